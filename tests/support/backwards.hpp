#pragma once

#include <cmath>

#include "armlet/model/robot.hpp"

namespace armlet {

// The arm read from its tool to its base.
inline Robot backwards(const Robot& robot) {
  const Chain& chain = robot.chain();
  const std::size_t n = static_cast<std::size_t>(chain.n);
  RobotSpec spec;
  spec.convention = DhConvention::kModified;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = n - 1 - i;
    Joint joint = robot.joint(static_cast<int>(j));
    joint.dh = {.theta = -chain.theta[j], .d = -chain.d[j]};
    if (i > 0) {
      joint.dh.a = -chain.a[n - i];
      joint.dh.alpha = std::atan2(-chain.sin_alpha[n - i], chain.cos_alpha[n - i]);
    }
    spec.joints.push_back(joint);
  }
  return Robot(spec);
}

}  // namespace armlet
