#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "armlet/model/link.hpp"
#include "armlet/model/robot.hpp"

namespace armlet {

enum class BodyJoint { kFixed, kRevolute, kPrismatic };

// The limits that a description gives to a mimic joint, rad or m; the actuator has its own. A speed
// of 0: not given.
struct CopyLimits {
  double lower = 0.0;
  double upper = 0.0;
  double max_speed = 0.0;
};

// A link of a mechanism and the joint that moves it. T_parent_joint is the pose of the link's frame
// in its parent at the zero of the joint. A revolute joint rotates about `axis`, a prismatic one
// moves along it. The link's mass, centre and inertia are in its own frame.
struct Body {
  std::string name;
  std::string joint_name{};
  int parent = -1;  // an earlier body, or -1: the base
  BodyJoint joint = BodyJoint::kFixed;
  Eigen::Isometry3d T_parent_joint = Eigen::Isometry3d::Identity();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // in the joint's frame; normalised
  Link link{};
  // Why the mass and inertia of its description are ignored, a clause; empty: they are used.
  std::string inertia_fault{};
  std::optional<CopyLimits> copy_limits{};
};

// An actuator of joints, in rad and m, N m and N. A rate or an effort of 0 is not given.
struct Actuator {
  std::string name;
  double lower = 0.0;
  double upper = 0.0;
  double max_speed = 0.0;
  double max_effort = 0.0;
};

// A named frame fixed to a body.
struct Tip {
  std::string name;
  int body = -1;
  Eigen::Isometry3d T_body_tip = Eigen::Isometry3d::Identity();
};

// Everything that defines a tree of links; Mechanism checks it.
//
// coupling, offset  joint values are coupling q + offset, with one row per revolute or prismatic
//                   joint, in the order of the bodies, and one column per actuator. Empty: each
//                   joint has its own actuator.
struct MechanismSpec {
  std::string name = "mechanism";
  std::string source;
  std::string base_name = "base";
  Link base{};  // masses and shapes of the base, in its frame
  std::vector<Body> bodies;
  std::vector<Actuator> actuators;
  Eigen::MatrixXd coupling;
  Eigen::VectorXd offset;
  std::vector<Tip> tips;
  // Assumptions about what a description left open, one clause each.
  std::vector<std::string> notes;
  InertiaCheck inertia_check = InertiaCheck::kRigidBody;
};

// Links in a tree, with joints that may be coupled: hands, grippers, arms with mimic joints.
// Immutable after construction.
//
// source  R. Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 4.
class Mechanism {
 public:
  static constexpr std::size_t kMaxBodies = 1000;

  // Throws ArgumentError naming the link and the number that is wrong.
  explicit Mechanism(MechanismSpec spec);

  const std::string& name() const { return spec_.name; }
  const std::string& source() const { return spec_.source; }
  const MechanismSpec& spec() const { return spec_; }
  const std::vector<Body>& bodies() const { return spec_.bodies; }
  const std::vector<Actuator>& actuators() const { return spec_.actuators; }
  const std::vector<Tip>& tips() const { return spec_.tips; }

  int actuator_count() const { return static_cast<int>(spec_.actuators.size()); }
  int joint_count() const { return static_cast<int>(moving_.size()); }
  // The bodies with a revolute or prismatic joint, in order.
  const std::vector<int>& moving() const { return moving_; }
  // The joint of a body as an index into joint values, or -1 if it is fixed.
  int joint_of(int body) const { return joint_of_[static_cast<std::size_t>(body)]; }

  // The joint values coupling q + offset.
  //
  // q       actuator values; limits are not checked.
  // throws  ArgumentError unless there is one value for each actuator.
  Eigen::VectorXd joint_values(const Eigen::Ref<const Eigen::VectorXd>& q) const;

  // The body of that name. Throws ArgumentError if there is none.
  int body(std::string_view name) const;
  // The tip of that name. Throws ArgumentError if there is none.
  const Tip& tip(std::string_view name) const;

 private:
  MechanismSpec spec_;
  std::vector<int> moving_;
  std::vector<int> joint_of_;
};

}  // namespace armlet
