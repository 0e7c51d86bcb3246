#include "give.hpp"

#include <fmt/format.h>

namespace armlet::bind {

std::optional<Eigen::VectorXd> joint_argument(Vm& vm, const Robot& robot, Slot s, bool is_list,
                                              int parameter) {
  Eigen::VectorXd q;
  if (is_list) {
    const auto values = reals_value(s);
    q = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  } else {
    q = posj(s).vector();
  }
  if (q.size() != robot.n()) {
    static_cast<void>(failure(
        vm, "R0613", fmt::format("{} joint values for a robot with {} joints", q.size(), robot.n()),
        parameter));
    return std::nullopt;
  }
  if (!q.allFinite()) {
    static_cast<void>(not_finite(vm, "a joint value", q.sum(), parameter));
    return std::nullopt;
  }
  return q;
}

}  // namespace armlet::bind
