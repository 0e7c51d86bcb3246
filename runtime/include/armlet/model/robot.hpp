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

// How strictly link inertias are judged. Identified arms of the literature are published with
// effective inertias that no rigid body has; they are kept as they are.
enum class InertiaCheck { kRigidBody, kPublished };

// kHand    the joints drive fingers, which are robots of their own: no tool moves with them.
// kFinger  a finger of such a hand.
enum class RobotRole { kArm, kHand, kFinger };

// Two links of an arm, 0 the base and i what joint i moves, the larger number first.
using LinkPair = std::pair<int, int>;

class Mechanism;
struct JointCoupling;

// Everything that defines a serial arm; Robot checks it.
//
// joints        the rows of the table. One that copies another row (Joint::drive) moves its link
//               without a motor: it has neither rotor inertia nor friction, and its limits follow
//               from those of the joint that it copies.
// base          what does not move: masses and shapes in the frame of the base.
// allow, watch  pairs of links that are never, or always, compared with each other.
// T_base_first  the frame before the first row, seen from the base: in a description the first
//               joint need not be at the origin of the root link.
// followers     the same arm as a tree, in which only the links have masses that joints carry which
//               copy joints of the arm: a balancing cylinder. One actuator per joint of the arm.
//               Null: there are none. It never changes; all copies of the robot share it.
// no_dynamics   why forces cannot be computed, a sentence; empty: they can.
// notes         what was assumed where the source of the arm left something open, one clause each.
struct RobotSpec {
  std::string name = "robot";
  std::string source;  // where the numbers come from
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
  Tool tool;                                                        // the hand
  Payload payload;                                                  // what it holds
  Eigen::Vector3d gravity{0.0, 0.0, -9.81};  // acceleration in world axes, m/s^2
  Eigen::VectorXd home;                      // empty: zero, or the nearest value within the limits
  std::shared_ptr<const Mechanism> followers;
  std::string no_dynamics;
  std::vector<std::string> notes;
};

// A serial arm that never changes after construction; it may be shared between threads.
class Robot {
 public:
  // Throws ArgumentError naming the joint or link and the number that is wrong.
  explicit Robot(RobotSpec spec);

  // The number of joint values, and that of the rows of the table and of the links, which is larger
  // where rows copy others.
  int n() const { return n_; }
  int rows() const { return chain_.n; }
  const std::string& name() const { return spec_.name; }
  const std::string& source() const { return spec_.source; }
  const RobotSpec& spec() const { return spec_; }

  // The joint of value i, and the row that it moves; the two numbers differ behind a row that
  // copies.
  const Joint& joint(int i) const { return row(row_of(i)); }
  int row_of(int i) const { return row_of_[static_cast<std::size_t>(i)]; }
  const Joint& row(int k) const { return spec_.joints[static_cast<std::size_t>(k)]; }
  // The link with the motor and the friction of joint i.
  const Link& motor_link(int i) const { return link(row_of(i)); }
  const Link& link(int i) const { return spec_.links[static_cast<std::size_t>(i)]; }
  // 0: the base; i: what row i moves, counted from 1.
  const Link& body(int i) const { return i == 0 ? spec_.base : link(i - 1); }
  // Whether the shape of the base or of a link was given, not made from the joint table.
  bool has_shapes() const;
  bool is_revolute(int i) const { return chain_.revolute[static_cast<std::size_t>(row_of(i))]; }

  // How the rows follow from the joint values where rows copy others; null: no row does.
  const JointCoupling* coupling() const { return coupling_.get(); }
  // The same arm with a joint of its own for each row: this one unless rows copy others. Shapes and
  // collisions that depend on rows alone are worked out for it.
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

  // What another layer works out once for this arm and keeps with it, one value of each type, such
  // as its closed form. The constructor of T says what the value depends on. One that takes a Chain
  // sees nothing but the geometry, and the value is shared by all copies with the same chain,
  // whatever their limits, rates, home and name. One that takes a Robot may use all of it, and
  // the value is shared by copies with nothing changed; one with a member type FromShape uses
  // neither name, payload nor rates, and is shared by copies that differ in these alone. As
  // DerivedValues::get otherwise.
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

  // Copies with one thing changed. with_tool puts the tool point at the hand's length along the
  // flange's z axis; with_tool_point moves the point and keeps the hand.
  // throws  ArgumentError where the constructor would: a pose that is none, a tool with an
  //         impossible number, a home of another size or outside the limits.
  Robot with_name(std::string name) const;
  Robot with_base(const Eigen::Isometry3d& T_world_base) const;
  Robot with_tool(const Tool& tool) const;
  Robot with_tool_point(const Eigen::Isometry3d& T_flange_tool) const;
  Robot with_home(const Eigen::VectorXd& home) const;
  // Another payload; the one before is gone.
  // throws  ArgumentError for a negative mass and an inertia that no body has.
  Robot with_payload(const Payload& payload) const;
  // Another link i, 0 <= i < rows(): masses, motor and friction.
  // throws  ArgumentError that names the link for what no body has, and for a number without link.
  Robot with_link(int i, const Link& link) const;
  // Limits of all joints, n numbers each, rad or m. A home position outside of them moves to the
  // nearest value inside.
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

  // A copy described by another spec; the second has the same shape, limits and home.
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
