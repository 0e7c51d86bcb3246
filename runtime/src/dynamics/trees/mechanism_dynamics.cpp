#include "armlet/dynamics/mechanism_dynamics.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/det_math.hpp"
#include "spatial_tree.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

void check_result(const Mechanism& mechanism, const VectorXd& result, std::string_view what) {
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    if (std::isfinite(result[i])) continue;
    throw ArgumentError(fmt::format(
        "The {} of actuator `{}` of `{}` is beyond the range of numbers; expected values and rates "
        "of ordinary size.",
        what, mechanism.actuators()[static_cast<std::size_t>(i)].name, mechanism.name()));
  }
}

// The forces that the motors at the joints need for their own inertia.
VectorXd motor_forces(const Mechanism& mechanism, const VectorXd& rates,
                      const VectorXd& accelerations) {
  VectorXd tau(mechanism.joint_count());
  for (int j = 0; j < mechanism.joint_count(); ++j) {
    const auto body = static_cast<std::size_t>(mechanism.moving()[static_cast<std::size_t>(j)]);
    const Link& link = mechanism.bodies()[body].link;
    tau[j] =
        squared_gear(link) * link.motor_inertia * accelerations[j] + link_friction(link, rates[j]);
  }
  return tau;
}

}  // namespace

double link_friction(const Link& link, double qd) {
  if (qd == 0.0) return 0.0;
  const Friction& f = link.friction;
  double dry = qd > 0.0 ? f.coulomb_plus : f.coulomb_minus;
  if (f.stribeck_speed > 0.0) {
    const double ratio = link.gear * qd / f.stribeck_speed;
    dry += (std::copysign(f.static_torque, qd) - dry) * det::exp(-ratio * ratio);
  }
  return squared_gear(link) * f.viscous * qd + std::abs(link.gear) * dry;
}

VectorXd inverse_dynamics(const Mechanism& mechanism, const MechanismMotion& motion,
                          const Vector3d& gravity) {
  check_motion(mechanism, motion, gravity);
  const MatrixXd& C = mechanism.spec().coupling;
  const VectorXd rates = C * motion.qd, accelerations = C * motion.qdd;
  const VectorXd joints =
      SpatialTree(mechanism, motion.q).joint_forces(rates, accelerations, gravity) +
      motor_forces(mechanism, rates, accelerations);
  VectorXd tau = C.transpose() * joints;
  check_result(mechanism, tau, "force");
  return tau;
}

VectorXd gravity_forces(const Mechanism& mechanism, const VectorXd& q, const Vector3d& gravity) {
  const VectorXd still = VectorXd::Zero(mechanism.actuator_count());
  return inverse_dynamics(mechanism, {.q = q, .qd = still, .qdd = still}, gravity);
}

MatrixXd mass_matrix(const Mechanism& mechanism, const VectorXd& q) {
  check_values("q", q, mechanism);
  const MatrixXd& C = mechanism.spec().coupling;
  const MatrixXd M = C.transpose() * SpatialTree(mechanism, q).joint_inertia() * C;
  return 0.5 * (M + M.transpose());
}

VectorXd forward_dynamics(const Mechanism& mechanism, const VectorXd& q, const VectorXd& qd,
                          const VectorXd& tau, const Vector3d& gravity) {
  check_values("tau", tau, mechanism);
  const VectorXd still = VectorXd::Zero(mechanism.actuator_count());
  const VectorXd rest =
      tau - inverse_dynamics(mechanism, {.q = q, .qd = qd, .qdd = still}, gravity);
  const MatrixXd M = mass_matrix(mechanism, q);
  const Eigen::LLT<MatrixXd> factor(M);
  if (factor.info() != Eigen::Success) {
    Eigen::Index least = 0;
    M.diagonal().minCoeff(&least);
    throw ArgumentError(fmt::format(
        "The inertia matrix of `{}` is not positive definite: nothing resists actuator `{}`. "
        "Expected a mass that it moves, or a motor inertia.",
        mechanism.name(), mechanism.actuators()[static_cast<std::size_t>(least)].name));
  }
  VectorXd qdd = factor.solve(rest);
  check_result(mechanism, qdd, "acceleration");
  return qdd;
}

double kinetic_energy(const Mechanism& mechanism, const VectorXd& q, const VectorXd& qd) {
  check_values("qd", qd, mechanism);
  return 0.5 * qd.dot(mass_matrix(mechanism, q) * qd);
}

double potential_energy(const Mechanism& mechanism, const VectorXd& q, const Vector3d& gravity) {
  check_values("q", q, mechanism);
  check_finite("gravity", gravity);
  const SpatialTree tree(mechanism, q);
  const std::vector<Isometry3d>& frames = tree.frames();
  double energy = 0.0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Link& link = mechanism.bodies()[i].link;
    energy -= link.mass * gravity.dot(frames[i] * link.com);
  }
  return energy;
}

}  // namespace armlet
