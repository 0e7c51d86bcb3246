#include "checks.hpp"

#include <fmt/format.h>

#include <cmath>

namespace armlet {

void refuse_result(const Robot& robot, const JointVector& result, std::string_view what,
                   std::initializer_list<NamedJoints> arguments) {
  for (const NamedJoints& argument : arguments) check_finite(argument.name, argument.values);
  Eigen::Index joint = 0;
  while (joint < result.size() && std::isfinite(result[joint])) ++joint;
  throw ArgumentError(
      fmt::format("The {} of joint {} of robot `{}` is beyond the range of numbers; expected "
                  "values and rates of ordinary size.",
                  what, joint + 1, robot.name()));
}

}  // namespace armlet
