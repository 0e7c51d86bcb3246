#include "armlet/dynamics/mechanism_dynamics.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/det_math.hpp"
#include "dynamics/spatial_arm.hpp"
#include "model/body_inertia.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

void check_values(std::string_view name, const VectorXd& values, const Mechanism& mechanism) {
  check_size(name, values.size(), mechanism.actuator_count());
  check_finite(name, values);
}

void check_result(const Mechanism& mechanism, const VectorXd& result, std::string_view what) {
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    if (std::isfinite(result[i])) continue;
    throw ArgumentError(fmt::format(
        "The {} of actuator `{}` of `{}` is beyond the range of numbers; expected values and rates "
        "of ordinary size.",
        what, mechanism.actuators()[static_cast<std::size_t>(i)].name, mechanism.name()));
  }
}

double squared_gear(const Link& link) { return link.gear * link.gear; }

// As Link::friction describes it, at the joint.
double friction_of(const Link& link, double qd) {
  if (qd == 0.0) return 0.0;
  const Friction& f = link.friction;
  double dry = qd > 0.0 ? f.coulomb_plus : f.coulomb_minus;
  if (f.stribeck_speed > 0.0) {
    const double ratio = link.gear * qd / f.stribeck_speed;
    dry += (std::copysign(f.static_torque, qd) - dry) * det::exp(-ratio * ratio);
  }
  return squared_gear(link) * f.viscous * qd + std::abs(link.gear) * dry;
}

// A tree at one configuration, in spatial vectors about the origin of the base and in its axes, so
// that no vector is ever moved from body to body.
class SpatialTree {
 public:
  SpatialTree(const Mechanism& mechanism, const VectorXd& q) : mechanism_(mechanism) {
    const VectorXd values = mechanism.joint_values(q);
    for (std::size_t i = 0; i < mechanism.bodies().size(); ++i) {
      const Body& body = mechanism.bodies()[i];
      const int joint = mechanism.joint_of(at(i));
      Isometry3d T = body.parent >= 0 ? frames_[index(body.parent)] * body.T_parent_joint
                                      : body.T_parent_joint;
      frames_.push_back(joint >= 0 ? T * joint_motion(body, values[joint]) : T);
      axes_.push_back(axis_of(body, frames_[i]));
      inertias_.push_back(inertia_of(body.link, frames_[i]));
    }
  }

  // The forces of all joints; motors and friction are not in them.
  VectorXd joint_forces(const VectorXd& rates, const VectorXd& accelerations,
                        const Vector3d& gravity) const {
    const std::size_t count = frames_.size();
    Vector6d falling;
    falling << -gravity, Vector3d::Zero();
    std::vector<Vector6d> v(count), a(count), f(count);
    for (std::size_t i = 0; i < count; ++i) {
      const int parent = mechanism_.bodies()[i].parent, joint = mechanism_.joint_of(at(i));
      v[i] = parent < 0 ? Vector6d(Vector6d::Zero()) : v[index(parent)];
      a[i] = parent < 0 ? falling : a[index(parent)];
      if (joint >= 0) {
        const Vector6d own = axes_[i] * rates[joint];
        v[i] += own;
        a[i] += axes_[i] * accelerations[joint] + spatial_cross(v[i], own);
      }
      f[i] = inertias_[i] * a[i] + spatial_cross_force(v[i], inertias_[i] * v[i]);
    }
    VectorXd tau(mechanism_.joint_count());
    for (std::size_t i = count; i-- > 0;) {
      const int parent = mechanism_.bodies()[i].parent, joint = mechanism_.joint_of(at(i));
      if (joint >= 0) tau[joint] = axes_[i].dot(f[i]);
      if (parent >= 0) f[index(parent)] += f[i];
    }
    return tau;
  }

  // The inertia matrix of all joints, with the rotors.
  MatrixXd joint_inertia() const {
    MatrixXd H = MatrixXd::Zero(mechanism_.joint_count(), mechanism_.joint_count());
    std::vector<Matrix6d> composite = inertias_;
    for (std::size_t i = frames_.size(); i-- > 0;) {
      const Body& body = mechanism_.bodies()[i];
      if (body.parent >= 0) composite[index(body.parent)] += composite[i];
      const int joint = mechanism_.joint_of(at(i));
      if (joint < 0) continue;
      const Vector6d force = composite[i] * axes_[i];
      H(joint, joint) = axes_[i].dot(force) + squared_gear(body.link) * body.link.motor_inertia;
      for (int k = body.parent; k >= 0; k = mechanism_.bodies()[index(k)].parent) {
        const int other = mechanism_.joint_of(k);
        if (other >= 0) H(joint, other) = H(other, joint) = axes_[index(k)].dot(force);
      }
    }
    return H;
  }

  [[nodiscard]] const std::vector<Isometry3d>& frames() const { return frames_; }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  static int at(std::size_t i) { return static_cast<int>(i); }

  static Vector6d axis_of(const Body& body, const Isometry3d& T) {
    const Vector3d z = T.linear() * body.axis;
    Vector6d axis = Vector6d::Zero();
    if (body.joint == BodyJoint::kRevolute) axis << T.translation().cross(z), z;
    if (body.joint == BodyJoint::kPrismatic) axis.head<3>() = z;
    return axis;
  }

  static Matrix6d inertia_of(const Link& link, const Isometry3d& T) {
    const Vector3d c = T * link.com;
    const Matrix3d h = hat(link.mass * c);
    Matrix6d I;
    I << link.mass * Matrix3d::Identity(), -h, h,
        T.linear() * link.inertia * T.linear().transpose() - h * hat(c);
    return I;
  }

  const Mechanism& mechanism_;
  std::vector<Isometry3d> frames_;
  std::vector<Vector6d> axes_;
  std::vector<Matrix6d> inertias_;
};

// What the motors at the joints take for themselves.
VectorXd motor_forces(const Mechanism& mechanism, const VectorXd& rates,
                      const VectorXd& accelerations) {
  VectorXd tau(mechanism.joint_count());
  for (int j = 0; j < mechanism.joint_count(); ++j) {
    const auto body = static_cast<std::size_t>(mechanism.moving()[static_cast<std::size_t>(j)]);
    const Link& link = mechanism.bodies()[body].link;
    tau[j] =
        squared_gear(link) * link.motor_inertia * accelerations[j] + friction_of(link, rates[j]);
  }
  return tau;
}

}  // namespace

VectorXd inverse_dynamics(const Mechanism& mechanism, const MechanismMotion& motion,
                          const Vector3d& gravity) {
  check_values("q", motion.q, mechanism);
  check_values("qd", motion.qd, mechanism);
  check_values("qdd", motion.qdd, mechanism);
  check_finite("gravity", gravity);
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
