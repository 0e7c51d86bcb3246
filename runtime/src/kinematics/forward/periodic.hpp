#pragma once

#include <cmath>

#include "armlet/model/joint_coupling.hpp"

namespace armlet {

// Whether a joint has the same position after a revolution: it is revolute, and its mimic joints
// follow it by whole revolutions.
inline bool is_periodic(const Robot& robot, int joint) {
  const JointCoupling* coupling = robot.coupling();
  if (coupling == nullptr) [[likely]]
    return robot.is_revolute(joint);
  for (int k = 0; k < robot.rows(); ++k) {
    const double ratio = coupling->E(k, joint);
    if (ratio != 0.0 && !(robot.row(k).is_revolute() && ratio == std::round(ratio))) return false;
  }
  return true;
}

}  // namespace armlet
