#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "armlet/model/robot.hpp"

namespace armlet {

// Pose of the tool point in the world: T_world_base A_1(q_1) ... A_n(q_n) T_flange_tool.
//
// q       n joint values, rad or m; limits are not checked.
// throws  ArgumentError unless q has n finite elements.
// source  J. Denavit, R. S. Hartenberg, A kinematic notation for lower-pair mechanisms, Journal of
//         Applied Mechanics 22, 1955; B. Siciliano et al., Robotics, 2009, section 2.8.2.
Eigen::Isometry3d forward(const Robot& robot, JointsIn q);

// Pose of the frame after joint k in the world, without the tool; k counts from 1 and 0 is the
// base.
//
// throws  ArgumentError unless 0 <= k <= n and q has n finite elements.
Eigen::Isometry3d link_frame(const Robot& robot, JointsIn q, int k);

// The n frames after joints 1 to n in the world, without the tool; q and what is thrown as for
// forward().
std::vector<Eigen::Isometry3d> link_frames(const Robot& robot, JointsIn q);

// The frames of all joints, written to an array of the caller without allocation.
//
// frames   receives n poses. returns  the pose of the tool point in the world. throws   as
// forward(), and ArgumentError unless there are n frames.
Eigen::Isometry3d link_frames(const Robot& robot, JointsIn q, std::span<Eigen::Isometry3d> frames);

}  // namespace armlet
