// A move as a program or a host asks for it.
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "armlet/control/policies.hpp"
#include "armlet/trajectory/cartesian_spline.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// A pose of the tool point in the world, or only a position, with which the arm keeps what it can
// of its orientation.
struct ToolPose {
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  bool has_orientation = true;
};

// The joints move together to these values, rad and m.
//
// any_branch  with MovePolicies::avoid: other joint values with the same tool pose will do.
struct JointTarget {
  Eigen::VectorXd q{};
  bool any_branch = false;
};

// The joints move together to the solution of the inverse kinematics that is nearest to `near`;
// empty: to the present joint values.
struct PoseTarget {
  ToolPose pose{};
  Eigen::VectorXd near{};
};

// The tool point moves on a straight line, or on the arc over p_world_via.
//
// tool_speed, tool_accel  of the tool point, m/s and m/s^2; nothing: as the joints allow.
struct LineTarget {
  ToolPose pose{};
  std::optional<Eigen::Vector3d> p_world_via{};
  std::optional<double> tool_speed{};
  std::optional<double> tool_accel{};
};

// The tool point moves on a smooth curve through poses; there is at least one.
struct CurveTarget {
  std::vector<ToolPose> poses{};
  SplineKind kind = SplineKind::kSpline3;
};

// One move of a path: of the joints to `q` (or to the solution near `near`), or of the tool point
// to the pose.
//
// blend  largest distance from the target at which its corner begins, m.
struct PathStep {
  ToolPose pose{};
  bool moves_joints = false;
  std::optional<Eigen::VectorXd> q{};
  Eigen::VectorXd near{};
  std::optional<Eigen::Vector3d> p_world_via{};
  double blend = 0.0;
  std::optional<double> tool_speed{};
  std::optional<double> tool_accel{};
};

// Several moves as one motion with rounded corners; there is at least one.
struct PathTarget {
  std::vector<PathStep> steps{};
};

// The motion is given. A caller that has planned it for this robot says that it is verified; then
// its joint limits and its ends are not checked again.
//
// planner    which made it.
// model      with which it was verified; null: the robot of the cell.
// length     of the path of the tool point, m; nothing: the distance between its ends.
struct GivenMotion {
  Trajectory motion{};
  std::string planner{};
  bool is_verified = false;
  std::shared_ptr<const Robot> model{};
  std::optional<double> length{};
};

using MoveTarget =
    std::variant<JointTarget, PoseTarget, LineTarget, CurveTarget, PathTarget, GivenMotion>;

// robot          index in the cell.
// planner        of joint moves, by name.
// time           whole duration, s; nothing: as fast as the limits allow.
// speed          fraction of the speed limits of the joints, above 0 and at most 1; for joint moves
//                not together with time.
// accel          fraction of their acceleration limits, above 0 and at most 1.
// T_flange_tool  the tool point of this move, instead of the robot's own.
// time_left      the longest duration, s.
// fixed_time     the motion may not be made slower, as if it had a time.
struct MoveCommand {
  int robot = 0;
  MoveTarget target{};
  std::string planner = "Syn";
  std::optional<double> time{};
  std::optional<double> speed{};
  double accel = 1.0;
  std::optional<Eigen::Isometry3d> T_flange_tool{};
  MovePolicies policies{};
  double time_left = std::numeric_limits<double>::infinity();
  bool fixed_time = false;
};

}  // namespace armlet
