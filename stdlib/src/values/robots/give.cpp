#include "values/robots/give.hpp"

#include <fmt/format.h>

namespace armlet::bind {

Answer<Eigen::VectorXd> joint_argument(Vm& vm, const Robot& robot, JointList values,
                                       int parameter) {
  const Eigen::VectorXd q =
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  if (q.size() != robot.n()) {
    return failure(vm, "R0613",
                   fmt::format("{} joint value{} for a robot with {} joint{}", q.size(),
                               q.size() == 1 ? "" : "s", robot.n(), robot.n() == 1 ? "" : "s"),
                   parameter);
  }
  if (!q.allFinite()) return not_finite(vm, "a joint value", q.sum(), parameter);
  return q;
}

Answer<Eigen::VectorXd> joint_argument(Vm& vm, const Robot& robot, const PosJ& values,
                                       int parameter) {
  return joint_argument(vm, robot, std::span(values.q.data(), values.n), parameter);
}

Answer<Eigen::VectorXd> seed_of(Vm& vm, const RobotRef& r, const PosJ* near, int parameter) {
  if (near == nullptr) return state_of(vm, r).q;
  return joint_argument(vm, model_of(vm, r), *near, parameter);
}
Answer<Eigen::VectorXd> seed_of(Vm& vm, const RobotRef& r, JointList near, int parameter) {
  return joint_argument(vm, model_of(vm, r), near, parameter);
}

}  // namespace armlet::bind
