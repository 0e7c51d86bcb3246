#pragma once

#include <vector>

#include "armlet/model/joint.hpp"

namespace armlet {

// A joint of a kind with the default limits: -360 to 360 deg, or 0 to 1 m.
Joint joint_without_limits(JointKind kind);

// Sets the limits of joints from a table with one row lower, upper per joint (rad or m).
//
// throws  ArgumentError unless there is one row of two numbers for each joint. Robot checks their
//         order.
void set_limits(std::vector<Joint>& joints, const std::vector<std::vector<double>>& limits);

}  // namespace armlet
