#pragma once

#include <vector>

#include "armlet/model/robot.hpp"

namespace armlet {

// An arm of revolute joints with these rows in the standard convention, without limits.
inline Robot arm_of(const std::vector<DhRow>& rows) {
  RobotSpec spec;
  for (const DhRow& row : rows) {
    Joint joint;
    joint.dh = row;
    spec.joints.push_back(joint);
  }
  return Robot(spec);
}

}  // namespace armlet
