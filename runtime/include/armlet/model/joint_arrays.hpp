#pragma once

#include "armlet/model/robot.hpp"

namespace armlet {

// One number per joint and one per pair of joints; the storage is inside the object, without
// allocation.
using JointVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxJoints, 1>;
using JointMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxJoints, kMaxJoints>;

}  // namespace armlet
