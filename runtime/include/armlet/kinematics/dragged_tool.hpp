#pragma once

#include <string>
#include <vector>

#include "armlet/kinematics/forward.hpp"

namespace armlet {

// Where a tool is that was dragged towards a pose, as by a pointer in a 3D view.
//
// q             n joint values within the limits.
// T_world_tool  the pose of the tool there; distance (m) and angle (rad) from it to the goal.
// at_limit      joints at a limit that keep the tool from coming nearer, from 0.
struct DraggedTool {
  Eigen::VectorXd q;
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  double distance = 0.0;
  double angle = 0.0;
  std::vector<int> at_limit;

  bool has_position() const { return distance <= 1e-6; }
  bool has_pose() const { return has_position() && angle <= 1e-6; }
};

// gradually  the joints change by a bounded amount in one call: an orientation that the arm had to
//            give up comes back over several calls. For goals on a path, each call starting from
//            the result of the call before; false for a single goal.
struct DragOptions {
  bool gradually = true;
};

// Follows a goal from the present joint values without jumping to another solution of the arm: the
// tool comes as near to the position as it can, then as near to the orientation as it can at that
// position, with short steps of the joints. What is found is a local optimum: solve_ik searches all
// solutions, and may find one where the dragged tool is stopped by a joint limit.
//
// T_world_goal  the desired pose of the tool, in the world.
// q_now         n joint values, rad or m.
// throws        ArgumentError unless q_now has n finite elements and the goal is a pose up to 1e6 m.
// source        priorities: Y. Nakamura, H. Hanafusa, T. Yoshikawa, Task-priority based redundancy
//               control of robot manipulators, Int. J. Robotics Research 6(2), 1987; steps at
//               saddles: Y. Dauphin et al., Identifying and attacking the saddle point problem in
//               high-dimensional non-convex optimization, NIPS 2014.
DraggedTool drag_tool(const Robot& robot, const Eigen::Isometry3d& T_world_goal, JointsIn q_now,
                      const DragOptions& options = {});

// The pose that a dragged tool should keep while it moves to a position, for arms that cannot set
// all of an orientation: the heading of arms whose tool keeps its tilt; the orientation at q_now of
// other arms with fewer than six joints; the pose itself for the rest.
Eigen::Isometry3d pose_to_keep(const Robot& robot, const Eigen::Isometry3d& T_world_goal,
                               JointsIn q_now);

// A sentence that says how far the tool is from the goal and what stops it; empty if it is
// there.
std::string explain(const Robot& robot, const Eigen::Isometry3d& T_world_goal,
                    const DraggedTool& dragged);

}  // namespace armlet
