// What a joint table says of the axes of an arm and of the frames on them.
#pragma once

#include "armlet/model/robot.hpp"

namespace armlet {

// The frame after joint `link`, seen from the one in which its shapes are given: the latter moves
// with the joint before the row's constants (standard convention) or behind them (modified).
Eigen::Isometry3d T_frame_link(const Robot& robot, int link);

// The frame of the axis of joint k + 1, about or along its z, seen from frame k.
Eigen::Isometry3d T_frame_axis(const Robot& robot, int k);

// Whether only joints with parallel axes are between two frames. A joint table does not say where
// along these axes links are: most arms have them side by side, drawn from the table they lie in
// one plane.
bool may_be_side_by_side(const Robot& robot, int lower, int upper);

// The first frame that moves on the axis on which frame k moves.
int first_on_axis(const Robot& robot, int k);

}  // namespace armlet
