#pragma once

#include <string_view>

#include "armlet/math/check_finite.hpp"
#include "armlet/model/joint_arrays.hpp"
#include "kernels.hpp"

// Checks of arguments and results in this layer.
namespace armlet {

// Whether all are finite: a number that is not gives NaN in the sum of differences with itself.
[[gnu::always_inline]] inline bool all_finite(const double* values, Eigen::Index count) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < count; ++i) sum += values[i] - values[i];
  return sum == 0.0;
}

// Checks for one number per joint; the ArgumentError has the name and the sizes.
[[gnu::always_inline]] inline void check_joint_count(std::string_view name, JointsIn values,
                                                     const Robot& robot) {
  if (values.size() != robot.n()) [[unlikely]]
    check_size(name, values.size(), robot.n());
}
inline void check_joint_values(std::string_view name, JointsIn values, const Robot& robot) {
  check_joint_count(name, values, robot);
  if (!all_finite(values.data(), values.size())) [[unlikely]]
    check_finite(name, values);
}

struct NamedJoints {
  std::string_view name;
  JointsIn values;
};

// Throws an ArgumentError for a result that is not finite: it names the argument that is not, or
// the joint whose `what` is out of range.
[[noreturn]] void refuse_result(const Robot& robot, const JointVector& result,
                                std::string_view what,
                                std::initializer_list<NamedJoints> arguments);

inline DynamicsInput input_of(const Robot& robot, const double* q, const double* qd = nullptr,
                              const double* qdd = nullptr) {
  const DynamicsPlan& plan = robot.derived<RobotDynamics>().plan;
  return {robot.walk_plan(), plan, q, qd, qdd, plan.base_acceleration};
}

}  // namespace armlet
