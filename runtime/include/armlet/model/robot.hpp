#pragma once

#include <Eigen/Geometry>
#include <array>
#include <concepts>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "armlet/chain/chain.hpp"
#include "armlet/chain/walk_plan.hpp"
#include "armlet/model/derived_values.hpp"
#include "armlet/model/joint.hpp"
#include "armlet/model/link.hpp"
#include "armlet/model/tool.hpp"

namespace armlet {

// Joint values as an argument: any vector, or a column of a matrix, without a copy.
using JointsIn = const Eigen::Ref<const Eigen::VectorXd>&;

// How strictly link inertias are checked. Identified arms of the literature are published with
// effective inertias that no rigid body has; kPublished accepts them unchanged.
enum class InertiaCheck { kRigidBody, kPublished };

// kHand    its joints drive fingers, which are robots of their own; it moves no tool.
// kFinger  a finger of such a robot.
enum class RobotRole { kArm, kHand, kFinger };

// Two links of an arm, the larger number first; 0 is the base and i the link that joint i moves.
using LinkPair = std::pair<int, int>;

class Mechanism;
struct JointCoupling;

// Everything that defines a serial arm; Robot checks it.
//
// joints        the rows of the table. A mimic joint (Joint::drive) moves its link without a motor:
//               it has neither rotor inertia nor friction, and its limits follow from those of its
//               source joint.
// base          the fixed part: masses and shapes in the frame of the base.
// allow, watch  pairs of links that are never, or always, checked for collisions.
// T_base_first  pose of the frame before the first row in the base: in a robot description the
//               first joint need not be at the origin of the root link.
// followers     the same arm as a tree in which only links behind mimic joints of the arm have
//               masses: for example a balancing cylinder. One actuator per joint of the arm. Null:
//               there are none. It is immutable and shared by all copies of the robot.
// no_dynamics   why forces cannot be computed, a sentence; empty: they can.
// notes         assumptions about what the source of the arm left open, one clause each.
struct RobotSpec {
  std::string name = "robot";
  std::string source;  // of the numbers
  RobotRole role = RobotRole::kArm;
  DhConvention convention = DhConvention::kStandard;
  std::vector<Joint> joints;  // 1 to kMaxJoints
  std::vector<Link> links;    // as many as rows, or none for an arm without mass
  Link base;
  std::vector<LinkPair> allow, watch;
  InertiaCheck inertia_check = InertiaCheck::kRigidBody;
  Eigen::Isometry3d T_world_base = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_base_first = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_flange_tool = Eigen::Isometry3d::Identity();  // the tool point
  Tool tool;
  Payload payload;                           // the held object
  Eigen::Vector3d gravity{0.0, 0.0, -9.81};  // acceleration in world axes, m/s^2
  Eigen::VectorXd home;                      // empty: zero, or the nearest value within the limits
  std::shared_ptr<const Mechanism> followers;
  std::string no_dynamics;
  std::vector<std::string> notes;
};

// A serial arm, immutable after construction; it may be shared between threads.
class Robot {
 public:
  // Throws ArgumentError naming the joint or link and the number that is wrong.
  explicit Robot(RobotSpec spec);

  // The number of joint values; and the number of rows of the table and of links, which is larger
  // if there are mimic joints.
  int n() const { return n_; }
  int rows() const { return chain_.n; }
  const std::string& name() const { return spec_.name; }
  const std::string& source() const { return spec_.source; }
  const RobotSpec& spec() const { return spec_; }

  // The joint of value i, and the row that it moves; the two numbers differ after the row of a
  // mimic joint.
  const Joint& joint(int i) const { return row(row_of(i)); }
  int row_of(int i) const { return row_of_[static_cast<std::size_t>(i)]; }
  const Joint& row(int k) const { return spec_.joints[static_cast<std::size_t>(k)]; }
  // The link with the motor and the friction of joint i.
  const Link& motor_link(int i) const { return link(row_of(i)); }
  const Link& link(int i) const { return spec_.links[static_cast<std::size_t>(i)]; }
  // 0: the base; i: what row i moves, counted from 1.
  const Link& body(int i) const { return i == 0 ? spec_.base : link(i - 1); }
  // Whether the shape of the base or of a link was given, rather than made from the joint table.
  bool has_shapes() const;
  bool is_revolute(int i) const { return chain_.revolute[static_cast<std::size_t>(row_of(i))]; }

  // How the rows follow from the joint values of an arm with mimic joints; null: there are none.
  const JointCoupling* coupling() const { return coupling_.get(); }
  // The arm with an independent joint for each row; *this if there are no mimic joints. Shapes and
  // collisions, which depend on rows alone, are computed for it.
  const Robot& uncoupled() const;

  const Eigen::Isometry3d& T_world_base() const { return spec_.T_world_base; }
  const Eigen::Isometry3d& T_flange_tool() const { return spec_.T_flange_tool; }
  const Tool& tool() const { return spec_.tool; }
  const Payload& payload() const { return spec_.payload; }
  const Eigen::Vector3d& gravity() const { return spec_.gravity; }
  const Eigen::VectorXd& home() const { return spec_.home; }

  // One number per joint, rad or m and their time derivatives.
  const Eigen::VectorXd& lower() const { return lower_; }
  const Eigen::VectorXd& upper() const { return upper_; }
  const Eigen::VectorXd& max_speed() const { return max_speed_; }
  const Eigen::VectorXd& max_accel() const { return max_accel_; }
  const Eigen::VectorXd& max_jerk() const { return max_jerk_; }

  // Characteristic length: sum of |a| + |d| over the rows, at least 0.1 m. It makes metres and
  // radians comparable.
  double length() const { return length_; }

  // Upper bound of the distance from the base to the tool point within the limits, m.
  double reach() const { return reach_; }

  // Constants for the kinematic recursions.
  const Chain& chain() const { return chain_; }
  const WalkPlan& walk_plan() const { return walk_plan_; }

  // A value that another layer computes once for this arm and stores with it, such as its closed
  // form; one value of each type. The constructor of T determines on what the value depends. If it
  // takes a Chain, the value depends on the geometry and is shared by all copies with the same
  // chain, whatever their limits, rates, home and name. If it takes a Robot, the value may depend
  // on everything and is shared by unchanged copies. If in addition T has a member type FromShape,
  // the value does not depend on name, payload and rates, and is shared by copies that differ in
  // these alone. Otherwise as DerivedValues::get.
  template <class T>
  const T& derived() const {
    static_assert(std::constructible_from<T, const Chain&> !=
                  std::constructible_from<T, const Robot&>);
    if constexpr (std::constructible_from<T, const Chain&>) {
      return from_chain_.get<T>(chain_);
    } else if constexpr (requires { typename T::FromShape; }) {
      return from_shape_.get<T>(*this);
    } else {
      return from_robot_.get<T>(*this);
    }
  }

  // Copies with one thing changed. with_tool puts the tool point at the tool's length along the
  // flange's z axis; with_tool_point moves the point and keeps the tool.
  // throws  ArgumentError like the constructor: for a matrix that is not a pose, a tool with an
  //         impossible number, a home of another size or outside the limits.
  Robot with_name(std::string name) const;
  Robot with_base(const Eigen::Isometry3d& T_world_base) const;
  Robot with_tool(const Tool& tool) const;
  Robot with_tool_point(const Eigen::Isometry3d& T_flange_tool) const;
  Robot with_home(const Eigen::VectorXd& home) const;
  // Replaces the payload.
  // throws  ArgumentError for a negative mass and an inertia that no body has.
  Robot with_payload(const Payload& payload) const;
  // Replaces link i, 0 <= i < rows(): masses, motor and friction.
  // throws  ArgumentError with the name of the link for values that no body has, and for a number
  //         without a link.
  Robot with_link(int i, const Link& link) const;
  // Replaces the limits of all joints, n numbers each, rad or m. A home position outside of them
  // moves to the nearest value inside.
  //
  // throws  ArgumentError on a wrong size, a number that is not finite and limits that are swapped.
  Robot with_limits(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) const;
  // The acceleration limits multiplied by `fraction`, above 0 and at most 1. Throws ArgumentError
  // for another fraction.
  Robot with_acceleration(double fraction) const;

 private:
  RobotSpec spec_;
  int n_ = 0;
  std::array<int, kMaxJoints> row_of_{};           // of each joint
  std::shared_ptr<const JointCoupling> coupling_;  // copies of this robot share it
  Chain chain_;
  WalkPlan walk_plan_;
  Eigen::VectorXd lower_, upper_, max_speed_, max_accel_, max_jerk_;
  double length_ = 0.0;
  double reach_ = 0.0;
  DerivedValues from_chain_, from_shape_, from_robot_;

  // A copy with another spec; the second keeps shape, limits and home.
  Robot changed(RobotSpec spec) const;
  Robot changed_beside_shape(RobotSpec spec) const;
};

// Joints from a table with one row theta, d, a, alpha per joint (rad, m) and a word such as "RRPR".
// Prismatic joints get limits 0 to 1 m, revolute ones -360 to 360 deg.
//
// throws  ArgumentError if a row has not 4 numbers, the word has another length or another letter.
std::vector<Joint> joints_from_table(const std::vector<std::vector<double>>& rows,
                                     std::string_view kinds);

}  // namespace armlet
