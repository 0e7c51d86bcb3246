#include <doctest/doctest.h>

#include "armlet/dynamics/forward_dynamics.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "random_mass.hpp"

using namespace armlet;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// J from what it does to forces: column by column of J', since J' w are the forces of a wrench.
MatrixXd jacobian_of(const Robot& robot, const VectorXd& q) {
  MatrixXd J(6, robot.n());
  for (int k = 0; k < 6; ++k) J.row(k) = wrench_forces(robot, q, Vector6d::Unit(k)).transpose();
  return J;
}

}  // namespace

// Forces J' w accelerate the joints by M^-1 J' w and so the tool by J M^-1 J' w: the inertia of the
// tool times that is w again.
TEST_CASE("the inertia at the tool times the acceleration that a wrench causes is the wrench") {
  Random random(11);
  int regular = 0;
  for (int k = 0; k < 200; ++k) {
    const int n = 6 + k % (kMaxJoints - 5);
    const Robot robot = random_heavy_arm(random, n);
    const VectorXd q = random_values(random, n);
    const MatrixXd J = jacobian_of(robot, q), M = mass_matrix(robot, q);
    const auto Lambda = operational_inertia(M, J);
    if (!Lambda.ok()) continue;
    ++regular;
    const Matrix6d& L = Lambda.value();
    CHECK(L == L.transpose());
    CHECK(L.llt().info() == Eigen::Success);
    Vector6d w;
    for (double& x : w) x = random.uniform(-1.0, 1.0);
    const VectorXd zero = VectorXd::Zero(n);
    const VectorXd free = forward_dynamics(robot, q, zero, zero);
    const VectorXd pushed = forward_dynamics(robot, q, zero, wrench_forces(robot, q, w));
    const double condition = L.norm() * (J * M.llt().solve(J.transpose())).norm();
    CHECK((L * (J * (pushed - free)) - w).norm() < 1e-13 * condition * w.norm() + 1e-12);
  }
  CHECK(regular > 150);
}

TEST_CASE("an arm with fewer than six joints has no inertia in all six directions, and says so") {
  Random random(12);
  const Robot robot = random_heavy_arm(random, 4);
  const VectorXd q = random_values(random, 4);
  const auto none = operational_inertia(mass_matrix(robot, q), jacobian_of(robot, q));
  REQUIRE_FALSE(none.ok());
  CHECK(none.error().message.find("rank 4") != std::string::npos);
  CHECK_THROWS_AS((void)operational_inertia(MatrixXd::Zero(4, 4), jacobian_of(robot, q)),
                  ArgumentError);
  CHECK_THROWS_AS((void)operational_inertia(MatrixXd::Identity(3, 3), jacobian_of(robot, q)),
                  ArgumentError);
}
