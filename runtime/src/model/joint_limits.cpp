#include "armlet/model/joint_limits.hpp"

#include <fmt/format.h>

#include "armlet/core/error.hpp"

namespace armlet {

Joint joint_without_limits(JointKind kind) {
  Joint joint;
  joint.kind = kind;
  if (kind == JointKind::kPrismatic) {
    joint.lower = 0.0;
    joint.upper = 1.0;
  }
  return joint;
}

void set_limits(std::vector<Joint>& joints, const std::vector<std::vector<double>>& limits) {
  if (limits.size() != joints.size()) {
    throw ArgumentError(
        fmt::format("There are {} rows of limits for {} joints.", limits.size(), joints.size()));
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (limits[i].size() != 2) {
      throw ArgumentError(
          fmt::format("The limits of joint {} have {} numbers; expected 2: lower, upper.", i + 1,
                      limits[i].size()));
    }
    joints[i].lower = limits[i][0];
    joints[i].upper = limits[i][1];
  }
}

}  // namespace armlet
