#include "armlet/dynamics/coriolis.hpp"

#include "armlet/math/det_math.hpp"
#include "checks.hpp"
#include "coupled.hpp"
#include "friction.hpp"
#include "spatial_arm.hpp"
#include "trees/follower_forces.hpp"

namespace armlet {
namespace {

// The matrix with f x* m = F m for a force f and any motion m, where m x* f is the motion's effect
// on the force.
Matrix6d force_cross_matrix(const Vector6d& force) {
  const Eigen::Matrix3d f = hat(force.head<3>()), n = hat(force.tail<3>());
  Matrix6d F = Matrix6d::Zero();
  F.topRightCorner<3, 3>() = -f;
  F.bottomLeftCorner<3, 3>() = -f;
  F.bottomRightCorner<3, 3>() = -n;
  return F;
}

// The matrix that gives the force by which an inertia moving with v acts on a motion of its own;
// with this choice the Coriolis matrix has the Christoffel symbols.
Matrix6d coriolis_factor(const Matrix6d& inertia, const Vector6d& v) {
  const Matrix6d cross = spatial_cross_matrix(v);
  return 0.5 * (-cross.transpose() * inertia - inertia * cross + force_cross_matrix(inertia * v));
}

double friction_slope(const PlanLink& link, double qd) {
  const PlanFriction& friction = link.friction;
  if (friction.stribeck_rate == 0.0 || qd == 0.0) return friction.viscous;
  const double ratio = qd * friction.stribeck_rate;
  const double extra = qd > 0.0 ? friction.static_extra_plus : friction.static_extra_minus;
  return friction.viscous - 2.0 * ratio * friction.stribeck_rate * extra * det::exp(-ratio * ratio);
}

// The arm in motion, from the base to the last link, and the sums over all links beyond each joint.
struct MovingArm {
  SpatialArm arm;
  std::size_t n;
  // v x S of the joint, for the velocity of its own link
  std::array<Vector6d, kMaxJoints> axis_rate;
  std::array<Vector6d, kMaxJoints> parent_rate,
      parent_acceleration;                 // Psi' and Psi'' of the source
  std::array<Vector6d, kMaxJoints> force;  // of a link and all beyond it
  std::array<Matrix6d, kMaxJoints> inertia, factor;

  MovingArm(const Robot& robot, JointsIn q, JointsIn qd, const double* qdd)
      : arm(robot, q), n(static_cast<std::size_t>(robot.n())) {
    Vector6d v = Vector6d::Zero(), a = arm.base_acceleration;
    for (std::size_t i = 0; i < n; ++i) {
      const Vector6d& S = arm.axis[i];
      const double rate = qd[static_cast<Eigen::Index>(i)];
      parent_rate[i] = spatial_cross(v, S);
      parent_acceleration[i] = spatial_cross(a, S) + spatial_cross(v, parent_rate[i]);
      v += S * rate;
      axis_rate[i] = spatial_cross(v, S);
      a += axis_rate[i] * rate;
      if (qdd != nullptr) a += S * qdd[i];
      inertia[i] = arm.inertia[i];
      factor[i] = coriolis_factor(inertia[i], v);
      force[i] = inertia[i] * a + spatial_cross_force(v, inertia[i] * v);
    }
    for (std::size_t i = n - 1; i > 0; --i) {
      inertia[i - 1] += inertia[i];
      factor[i - 1] += factor[i];
      force[i - 1] += force[i];
    }
  }
};

// For an arm with independent rows, without links outside of the chain.
JointMatrix coriolis_of_chain(const Robot& robot, JointsIn q, JointsIn qd) {
  const MovingArm moving(robot, q, qd, nullptr);
  JointMatrix C(robot.n(), robot.n());
  for (std::size_t j = 0; j < moving.n; ++j) {
    const Vector6d& S = moving.arm.axis[j];
    const Vector6d own = moving.factor[j] * S + moving.inertia[j] * moving.axis_rate[j];
    const Vector6d across = moving.factor[j].transpose() * S, inert = moving.inertia[j] * S;
    const Eigen::Index column = static_cast<Eigen::Index>(j);
    for (std::size_t i = 0; i <= j; ++i) {
      const Eigen::Index row = static_cast<Eigen::Index>(i);
      C(row, column) = moving.arm.axis[i].dot(own);
      C(column, row) = across.dot(moving.arm.axis[i]) + inert.dot(moving.axis_rate[i]);
    }
  }
  return C;
}

ForceDerivatives derivatives_of_chain(const Robot& robot, JointsIn q, JointsIn qd, JointsIn qdd) {
  const MovingArm moving(robot, q, qd, qdd.data());
  ForceDerivatives result{JointMatrix(robot.n(), robot.n()), JointMatrix(robot.n(), robot.n())};
  for (std::size_t j = 0; j < moving.n; ++j) {
    const Vector6d& S = moving.arm.axis[j];
    const Matrix6d twice = 2.0 * moving.factor[j];
    const auto by_q = [&](std::size_t k) -> Vector6d {
      return twice * moving.parent_rate[k] + moving.inertia[j] * moving.parent_acceleration[k];
    };
    const auto by_qd = [&](std::size_t k) -> Vector6d {
      return twice * moving.arm.axis[k] +
             moving.inertia[j] * (moving.parent_rate[k] + moving.axis_rate[k]);
    };
    const Vector6d own_q = by_q(j) + spatial_cross_force(S, moving.force[j]), own_qd = by_qd(j);
    const Eigen::Index column = static_cast<Eigen::Index>(j);
    for (std::size_t i = 0; i <= j; ++i) {
      const Eigen::Index row = static_cast<Eigen::Index>(i);
      result.by_q(row, column) = moving.arm.axis[i].dot(own_q);
      result.by_qd(row, column) = moving.arm.axis[i].dot(own_qd);
      result.by_q(column, row) = S.dot(by_q(i));
      result.by_qd(column, row) = S.dot(by_qd(i));
    }
  }
  const DynamicsPlan& plan = robot.derived<RobotDynamics>().plan;
  for (Eigen::Index i = 0; i < qd.size(); ++i) {
    result.by_qd(i, i) += friction_slope(plan.links[i], qd[i]);
  }
  return result;
}

}  // namespace

JointMatrix coriolis_matrix(const Robot& robot, JointsIn q, JointsIn qd) {
  check_joint_values("q", q, robot);
  check_joint_values("qd", qd, robot);
  const JointCoupling* coupling = robot.coupling();
  JointMatrix C = coupling == nullptr
                      ? coriolis_of_chain(robot, q, qd)
                      : for_joints(*coupling, coriolis_of_chain(coupling->rows, coupling->values(q),
                                                                coupling->rates(qd)));
  if (has_followers(robot)) add_follower_coriolis(robot, q, qd, C);
  check_finite("Coriolis matrix", C);
  return C;
}

ForceDerivatives inverse_dynamics_derivatives(const Robot& robot, JointsIn q, JointsIn qd,
                                              JointsIn qdd) {
  check_joint_values("q", q, robot);
  check_joint_values("qd", qd, robot);
  check_joint_values("qdd", qdd, robot);
  ForceDerivatives result;
  if (const JointCoupling* coupling = robot.coupling()) {
    const ForceDerivatives of_rows = derivatives_of_chain(
        coupling->rows, coupling->values(q), coupling->rates(qd), coupling->rates(qdd));
    result = {for_joints(*coupling, of_rows.by_q), for_joints(*coupling, of_rows.by_qd)};
  } else {
    result = derivatives_of_chain(robot, q, qd, qdd);
  }
  if (has_followers(robot)) add_follower_derivatives(robot, q, qd, qdd, result.by_q, result.by_qd);
  check_finite("derivative by q", result.by_q);
  check_finite("derivative by qd", result.by_qd);
  return result;
}

}  // namespace armlet
