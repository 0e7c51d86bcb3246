#include <fmt/format.h>

#include <cmath>

#include "armlet/dynamics/batch.hpp"
#include "batch_table.hpp"
#include "chain/batch_lines.hpp"
#include "chain/batch_plan.hpp"
#include "dynamics/checks.hpp"
#include "dynamics/coupled.hpp"
#include "dynamics/friction.hpp"
#include "dynamics/trees/follower_forces.hpp"

namespace armlet {
namespace {

const DynamicsBatchKernels& kernels_for(InstructionSet set, std::size_t count) {
  return kernels_for(set, count, kAvx512Dynamics, kAvx2Dynamics, kBaselineDynamics);
}

// The baseline has two lanes, of which a single motion uses one.
bool one_motion(const Robot& robot, const DynamicsPlan& plan, const MotionBatch& batch,
                double* tau) {
  kernel_for(kInverseKernels, plan)(
      {robot.walk_plan(), plan, batch.q, batch.qd, batch.qdd, plan.base_acceleration}, tau);
  if (plan.friction == FrictionKind::kCoulomb) add_friction(plan, batch.qd, tau);
  return all_finite(tau, static_cast<Eigen::Index>(plan.n));
}

bool add_stribeck(const DynamicsPlan& plan, const MotionBatch& batch, double* tau) {
  for (std::size_t i = 0; i < plan.n; ++i) {
    for (std::size_t at = i * batch.count; at < (i + 1) * batch.count; ++at) {
      tau[at] += joint_friction(plan.links[i], batch.qd[at]);
    }
  }
  return all_finite(tau, static_cast<Eigen::Index>(plan.n * batch.count));
}

// Forces of an arm with mimic joints, without links outside of the chain.
void coupled_forces(const JointCoupling& coupling, std::span<const double> q,
                    std::span<const double> qd, std::span<const double> qdd, std::span<double> tau,
                    InstructionSet set) {
  const Eigen::Index n = coupling.E.cols();
  const Eigen::Index count = static_cast<Eigen::Index>(q.size()) / n;
  const auto lines = [&](std::span<const double> values) {
    return Eigen::Map<const BatchLines>(values.data(), n, count);
  };
  BatchLines position = coupling.E * lines(q);
  position.colwise() += coupling.offset;
  const BatchLines rate = coupling.E * lines(qd), acceleration = coupling.E * lines(qdd);
  BatchLines forces(coupling.rows.n(), count);
  inverse_dynamics_batch(coupling.rows, numbers_of(position), numbers_of(rate),
                         numbers_of(acceleration),
                         {forces.data(), static_cast<std::size_t>(forces.size())}, set);
  Eigen::Map<BatchLines>(tau.data(), n, count) = coupling.E.transpose() * forces;
}

bool add_followers(const Robot& robot, const MotionBatch& batch, double* tau) {
  const auto count = static_cast<Eigen::Index>(batch.count);
  const Eigen::Map<const BatchLines> q(batch.q, robot.n(), count), qd(batch.qd, robot.n(), count),
      qdd(batch.qdd, robot.n(), count);
  Eigen::Map<BatchLines> all(tau, robot.n(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    JointVector more = JointVector::Zero(robot.n());
    const Eigen::VectorXd rate = qd.col(k);
    add_follower_forces(robot, q.col(k), rate, qdd.col(k), true, more);
    add_follower_friction(robot, rate, more);
    all.col(k) += more;
  }
  return all_finite(tau, static_cast<Eigen::Index>(robot.n()) * count);
}

[[noreturn]] void refuse_result(const Robot& robot, std::span<const double> tau,
                                std::size_t count) {
  std::size_t at = 0;
  while (at + 1 < tau.size() && std::isfinite(tau[at])) ++at;
  throw ArgumentError(fmt::format(
      "The force of joint {} of robot `{}` in motion {} is not finite; expected finite values and "
      "rates of ordinary size.",
      at / count + 1, robot.name(), at % count + 1));
}

}  // namespace

void inverse_dynamics_batch(const Robot& robot, std::span<const double> q,
                            std::span<const double> qd, std::span<const double> qdd,
                            std::span<double> tau, InstructionSet set) {
  check_supported(set);
  const std::size_t n = static_cast<std::size_t>(robot.n());
  const std::size_t count = count_configurations(q, n);
  const Eigen::Index expected = static_cast<Eigen::Index>(q.size());
  check_size("qd", static_cast<Eigen::Index>(qd.size()), expected);
  check_size("qdd", static_cast<Eigen::Index>(qdd.size()), expected);
  check_size("tau", static_cast<Eigen::Index>(tau.size()), expected);
  if (count == 0) return;
  const DynamicsPlan& plan = robot.derived<RobotDynamics>().plan;
  const BatchArm arm = batch_arm(robot.walk_plan());
  const MotionBatch batch = {arm, plan, q.data(), qd.data(), qdd.data(), count};
  bool finite = true;
  if (const JointCoupling* coupling = robot.coupling()) [[unlikely]] {
    coupled_forces(*coupling, q, qd, qdd, tau, set);
    finite = all_finite(tau.data(), expected);
  } else {
    finite = count == 1 ? one_motion(robot, plan, batch, tau.data())
                        : kernels_for(set, count).inverse(batch, tau.data());
    if (plan.friction == FrictionKind::kStribeck)
      finite = add_stribeck(plan, batch, tau.data()) && finite;
  }
  if (has_followers(robot)) [[unlikely]]
    finite = add_followers(robot, batch, tau.data()) && finite;
  if (!finite) [[unlikely]]
    refuse_result(robot, tau, count);
}

}  // namespace armlet
