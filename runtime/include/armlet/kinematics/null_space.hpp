#pragma once

#include <array>
#include <vector>

#include "armlet/kinematics/jacobian.hpp"
#include "armlet/kinematics/posture.hpp"

namespace armlet {

// Self-motion: an arm with more joints than its task has rows can move without moving the tool,
// which serves to improve the posture.

// The rows of the motion [v; w] of the tool point that matter, in world or tool axes.
struct TaskRows {
  std::array<bool, 6> counts{true, true, true, true, true, true};
  JacobianFrame axes = JacobianFrame::kWorld;
};

// I - V_r V_r^T: maps joint speeds to the nearest ones that do not move the tool. The rank is
// decided by the singular values, so that near a singularity no part of the motion moves the tool.
//
// q        n joint values, rad or m.
// returns  n x n.
// throws   ArgumentError unless q has n finite elements.
// source   B. Siciliano et al., Robotics, 2009, section 3.5.1, with the singular value
//          decomposition instead of the right pseudo-inverse.
Eigen::MatrixXd null_space_projector(const Robot& robot, JointsIn q, const TaskRows& rows = {});

// One step of self-motion: q + dt P qd, then one Newton step that corrects the drift of the tool
// from T_world_tool.
//
// q, qd    n joint values, rad or m, and the desired rates; P is the projector above.
// dt       the length of the step, s.
// returns  n joint values; limits are not checked.
// throws   ArgumentError unless q and qd have n finite elements.
// source   A. Liegeois, Automatic supervisory control of the configuration and behavior of
//          multibody mechanisms, IEEE Trans. SMC 7(12), 1977.
Eigen::VectorXd self_motion_step(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                                 JointsIn q, JointsIn qd, double dt, const TaskRows& rows = {});

// Moves the arm within its limits to a better posture by self-motion: the tool does not move in the
// given rows.
//
// q        n joint values within the limits, rad or m.
// steps    largest number of steps of self-motion.
// returns  n joint values whose posture is at least as good.
// throws   ArgumentError unless q, and q_given of a posture that has one, have n elements.
// source   Liegeois 1977: the projected gradient of the posture.
Eigen::VectorXd improve_posture(const Robot& robot, JointsIn q, const PostureGoal& goal,
                                const TaskRows& rows = {}, int steps = 200);

// Joint speeds, rad/s or m/s, that move the tool with a twist [v; w], m/s and rad/s, and are as
// near as possible to desired ones, within bounds: a joint that would exceed its bound is kept at
// it, and the other joints compensate.
//
// lower, upper  bounds of the speeds, n values.
// reached       whether the twist is attained; otherwise the bounds are too narrow for it.
// saturated     the joints at a bound, from 0.
// throws        ArgumentError unless q, qd_wished, lower and upper have n elements.
// source        F. Flacco, A. De Luca, O. Khatib, Motion control of redundant robots under joint
//               constraints: saturation in the null space, ICRA 2012.
struct BoundedSpeeds {
  Eigen::VectorXd qd;
  bool reached = true;
  std::vector<int> saturated;
};
BoundedSpeeds bounded_joint_speeds(const Robot& robot, JointsIn q, const Vector6d& twist,
                                   JointsIn qd_wished, JointsIn lower, JointsIn upper,
                                   const TaskRows& rows = {});

}  // namespace armlet
