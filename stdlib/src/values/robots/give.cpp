#include "values/robots/give.hpp"

#include <fmt/format.h>

namespace armlet::bind {

Answer<Eigen::VectorXd> joint_argument(Vm& vm, const Robot& robot, JointList values,
                                       CallPart part) {
  const Eigen::VectorXd q =
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  if (q.size() != robot.n()) {
    return failure(vm, "R0613",
                   fmt::format("{} joint value{} for a robot with {} joint{}", q.size(),
                               q.size() == 1 ? "" : "s", robot.n(), robot.n() == 1 ? "" : "s"),
                   part);
  }
  if (!q.allFinite()) return not_finite(vm, "a joint value", q.sum(), part);
  return q;
}

Answer<Eigen::VectorXd> joint_argument(Vm& vm, const Robot& robot, const PosJ& values,
                                       CallPart part) {
  return joint_argument(vm, robot, std::span(values.q.data(), values.n), part);
}

Answer<Eigen::VectorXd> seed_of(Vm& vm, const RobotRef& r, const PosJ* near, CallPart part) {
  if (near == nullptr) return state_of(vm, r).q;
  return joint_argument(vm, model_of(vm, r), *near, part);
}
Answer<Eigen::VectorXd> seed_of(Vm& vm, const RobotRef& r, JointList near, CallPart part) {
  return joint_argument(vm, model_of(vm, r), near, part);
}

}  // namespace armlet::bind
