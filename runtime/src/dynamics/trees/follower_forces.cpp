#include "follower_forces.hpp"

#include <vector>

#include "armlet/dynamics/identification.hpp"
#include "armlet/dynamics/mechanism_dynamics.hpp"
#include "spatial_tree.hpp"

namespace armlet {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

Vector3d gravity_in_base(const Robot& robot) {
  return robot.T_world_base().linear().transpose() * robot.gravity();
}

VectorXd forces_of(const Robot& robot, const VectorXd& q, const VectorXd& qd, const VectorXd& qdd,
                   bool gravity) {
  const Mechanism& m = *robot.spec().followers;
  const MatrixXd& C = m.spec().coupling;
  const Vector3d g = gravity ? gravity_in_base(robot) : Vector3d::Zero();
  check_motion(m, {.q = q, .qd = qd, .qdd = qdd}, g);
  const VectorXd accelerations = C * qdd;
  VectorXd joints = SpatialTree(m, q).joint_forces(C * qd, accelerations, g);
  for (int j = 0; j < m.joint_count(); ++j) {
    const auto body = static_cast<std::size_t>(m.moving()[static_cast<std::size_t>(j)]);
    const Link& link = m.bodies()[body].link;
    joints[j] += squared_gear(link) * link.motor_inertia * accelerations[j];
  }
  return C.transpose() * joints;
}

// The bodies of the tree with nonzero parameters: the links of the arm have none in it.
std::vector<int> bodies_with_parameters(const VectorXd& all) {
  std::vector<int> bodies;
  for (Eigen::Index first = 0; first < all.size(); first += kLinkParameters) {
    if (!all.segment<kLinkParameters>(first).isZero(0.0))
      bodies.push_back(static_cast<int>(first / kLinkParameters));
  }
  return bodies;
}

}  // namespace

void add_follower_forces(const Robot& robot, JointsIn q, const VectorXd& qd, const VectorXd& qdd,
                         bool gravity, JointVector& tau) {
  const VectorXd still = VectorXd::Zero(robot.n());
  tau += forces_of(robot, q, qd.size() == 0 ? still : qd, qdd.size() == 0 ? still : qdd, gravity);
}

void add_follower_friction(const Robot& robot, JointsIn qd, JointVector& tau) {
  const Mechanism& m = *robot.spec().followers;
  const MatrixXd& C = m.spec().coupling;
  VectorXd joints = C * qd;
  for (int j = 0; j < m.joint_count(); ++j) {
    const auto body = static_cast<std::size_t>(m.moving()[static_cast<std::size_t>(j)]);
    joints[j] = link_friction(m.bodies()[body].link, joints[j]);
  }
  tau += C.transpose() * joints;
}

void add_follower_inertia(const Robot& robot, JointsIn q, JointMatrix& M) {
  M += mass_matrix(*robot.spec().followers, q);
}

void add_follower_coriolis(const Robot& robot, JointsIn q, JointsIn qd, JointMatrix& C) {
  const VectorXd still = VectorXd::Zero(robot.n());
  const VectorXd whole = forces_of(robot, q, qd, still, false);
  for (Eigen::Index j = 0; j < robot.n(); ++j) {
    const VectorXd unit = VectorXd::Unit(robot.n(), j);
    C.col(j) += 0.5 * (forces_of(robot, q, qd + unit, still, false) - whole -
                       forces_of(robot, q, unit, still, false));
  }
}

void add_follower_derivatives(const Robot& robot, JointsIn q, JointsIn qd, JointsIn qdd,
                              JointMatrix& by_q, JointMatrix& by_qd) {
  constexpr double kStep = 1e-3;
  const Mechanism& m = *robot.spec().followers;
  const auto at = [&](Eigen::Index j, double steps) {
    VectorXd beside = q;
    beside[j] += steps * kStep;
    return forces_of(robot, beside, qd, qdd, true);
  };
  for (Eigen::Index j = 0; j < robot.n(); ++j)
    by_q.col(j) += (8.0 * (at(j, 1.0) - at(j, -1.0)) - (at(j, 2.0) - at(j, -2.0))) / (12.0 * kStep);
  JointMatrix C = JointMatrix::Zero(robot.n(), robot.n());
  add_follower_coriolis(robot, q, qd, C);
  VectorXd viscous(m.joint_count());
  for (int j = 0; j < m.joint_count(); ++j) {
    const auto body = static_cast<std::size_t>(m.moving()[static_cast<std::size_t>(j)]);
    const Link& link = m.bodies()[body].link;
    viscous[j] = squared_gear(link) * link.friction.viscous;
  }
  const MatrixXd& coupling = m.spec().coupling;
  by_qd += 2.0 * C + coupling.transpose() * viscous.asDiagonal() * coupling;
}

double follower_potential_energy(const Robot& robot, JointsIn q) {
  const Mechanism& m = *robot.spec().followers;
  double mass = 0.0;
  for (const Body& body : m.bodies()) mass += body.link.mass;
  return potential_energy(m, q, gravity_in_base(robot)) -
         mass * robot.gravity().dot(robot.T_world_base().translation());
}

VectorXd follower_parameters(const Robot& robot) {
  const VectorXd all = dynamic_parameters(*robot.spec().followers);
  const std::vector<int> bodies = bodies_with_parameters(all);
  VectorXd p(kLinkParameters * static_cast<Eigen::Index>(bodies.size()));
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    p.segment<kLinkParameters>(kLinkParameters * static_cast<Eigen::Index>(k)) =
        all.segment<kLinkParameters>(kLinkParameters * bodies[k]);
  }
  return p;
}

MatrixXd follower_regressor(const Robot& robot, JointsIn q, JointsIn qd, JointsIn qdd) {
  const Mechanism& m = *robot.spec().followers;
  const std::vector<int> bodies = bodies_with_parameters(dynamic_parameters(m));
  const MatrixXd all =
      dynamics_regressor(m, {.q = q, .qd = qd, .qdd = qdd}, gravity_in_base(robot));
  MatrixXd Y(all.rows(), kLinkParameters * static_cast<Eigen::Index>(bodies.size()));
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    Y.middleCols<kLinkParameters>(kLinkParameters * static_cast<Eigen::Index>(k)) =
        all.middleCols<kLinkParameters>(kLinkParameters * bodies[k]);
  }
  return Y;
}

}  // namespace armlet
