#include "armlet/dynamics/energy.hpp"

#include "armlet/dynamics/forward_dynamics.hpp"
#include "armlet/model/joint_coupling.hpp"
#include "checks.hpp"
#include "spatial_arm.hpp"
#include "trees/follower_forces.hpp"

namespace armlet {

double kinetic_energy(const Robot& robot, JointsIn q, JointsIn qd) {
  check_joint_values("qd", qd, robot);
  const double energy = 0.5 * qd.dot(mass_matrix(robot, q) * qd);
  check_finite("kinetic energy", energy);
  return energy;
}

// For an arm with independent rows, without links outside of the chain.
static double potential_energy_of_chain(const Robot& robot, JointsIn q) {
  const SpatialArm arm(robot, q);
  const std::array<double, 12>& base = robot.walk_plan().base;
  const Eigen::Vector3d origin(base[9], base[10], base[11]);
  double energy = 0.0;
  for (int i = 0; i < robot.n(); ++i) {
    const Moments link = moments_of_link(robot, i);
    const Eigen::Isometry3d& frame = arm.frame[static_cast<std::size_t>(i)];
    energy -=
        robot.gravity().dot(link.mass * (origin + frame.translation()) + frame.linear() * link.h);
  }
  return energy;
}

double potential_energy(const Robot& robot, JointsIn q) {
  check_joint_values("q", q, robot);
  const JointCoupling* coupling = robot.coupling();
  double energy = coupling == nullptr
                      ? potential_energy_of_chain(robot, q)
                      : potential_energy_of_chain(coupling->rows, coupling->values(q));
  if (has_followers(robot)) energy += follower_potential_energy(robot, q);
  check_finite("potential energy", energy);
  return energy;
}

}  // namespace armlet
