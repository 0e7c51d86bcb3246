// The axes of an arm and the frames on them, from its joint table.
#pragma once

#include "armlet/model/robot.hpp"

namespace armlet {

// Pose of the frame after joint `link` in the one in which its shapes are given: the latter moves
// with the joint before the row's constants (standard convention) or after them (modified).
Eigen::Isometry3d T_frame_link(const Robot& robot, int link);

// The frame of the axis of joint k + 1, about or along its z, seen from frame k.
Eigen::Isometry3d T_frame_axis(const Robot& robot, int k);

// Whether only joints with parallel axes are between two frames. A joint table does not determine
// the positions of links along these axes: in most arms they are side by side, but drawn from the
// table they are in one plane.
bool may_be_side_by_side(const Robot& robot, int lower, int upper);

// The first frame that moves on the axis of frame k.
int first_on_axis(const Robot& robot, int k);

}  // namespace armlet
