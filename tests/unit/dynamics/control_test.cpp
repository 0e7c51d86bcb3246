#include "armlet/dynamics/control.hpp"

#include <doctest/doctest.h>

#include "armlet/dynamics/forward_dynamics.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "armlet/math/det_math.hpp"
#include "random_mass.hpp"

using namespace armlet;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// J from what it does to forces: column by column of J', since J' w are the forces of a wrench.
MatrixXd jacobian_rows(const Robot& robot, const VectorXd& q, Index rows) {
  MatrixXd J(rows, robot.n());
  for (Index k = 0; k < rows; ++k) {
    J.row(k) = wrench_forces(robot, q, Vector6d::Unit(static_cast<int>(k))).transpose();
  }
  return J;
}

Compliance settled(const Vector6d& wrench, const Vector6d& mass, const Vector6d& damping,
                   const Vector6d& stiffness, double h, int steps) {
  Compliance state;
  for (int k = 0; k < steps; ++k) state = give_way(state, wrench, mass, damping, stiffness, h);
  return state;
}

}  // namespace

TEST_CASE("operational forces give the tool the acceleration that was asked for") {
  Random random(21);
  int regular = 0;
  for (int k = 0; k < 300; ++k) {
    const int n = 3 + k % (kMaxJoints - 2);
    const Index rows =
        1 + static_cast<Index>(random.below(static_cast<std::uint64_t>(std::min(n, 6))));
    const Robot robot = random_heavy_arm(random, n);
    const VectorXd q = random_values(random, n), qd = random_rates(random, n);
    const MatrixXd M = mass_matrix(robot, q), J = jacobian_rows(robot, q, rows);
    const VectorXd h = bias_forces(robot, q, qd), a = random_rates(random, static_cast<int>(rows));
    const auto tau = operational_forces(M, J, a, h, qd);
    if (!tau.ok()) continue;
    ++regular;
    const VectorXd qdd = forward_dynamics(robot, q, qd, tau.value());
    const double scale = 1e-9 * (1.0 + qdd.norm());
    CHECK((J * qdd - a).norm() < scale);
    // Damping of what the tool does not see changes nothing for it, and takes energy.
    const auto damped = operational_forces(M, J, a, h, qd, 5.0);
    REQUIRE(damped.ok());
    CHECK((J * forward_dynamics(robot, q, qd, damped.value()) - a).norm() < 10.0 * scale);
    CHECK(qd.dot(damped.value() - tau.value()) <= scale * (1.0 + qd.norm()));
  }
  CHECK(regular > 200);
}

TEST_CASE("directions that depend on each other are reported, and arguments that are none") {
  Random random(22);
  const Robot robot = random_heavy_arm(random, 4);
  const VectorXd q = random_values(random, 4), zero = VectorXd::Zero(4);
  const MatrixXd M = mass_matrix(robot, q), J = jacobian_rows(robot, q, 6);
  CHECK(operational_forces(M, J, VectorXd::Zero(6), zero, zero).error().code == "singular");
  CHECK_THROWS_AS((void)operational_forces(M, J, VectorXd::Zero(5), zero, zero), ArgumentError);
  CHECK_THROWS_AS((void)operational_forces(-M, J.topRows(2), VectorXd::Zero(2), zero, zero),
                  ArgumentError);
}

TEST_CASE("compliance: where a force is held, and the motion to it") {
  Vector6d f, m, d, k;
  f << 10.0, -20.0, 5.0, 0.5, 0.0, -0.25;
  m << 1.0, 2.0, 4.0, 0.1, 0.1, 0.2;
  k << 100.0, 400.0, 1000.0, 10.0, 5.0, 4.0;
  d = 2.0 * (m.array() * k.array()).sqrt();  // critically damped
  const double w = 10.0;                     // of the first direction, rad/s
  for (const int steps : {1, 10, 1000}) {
    const double t = 0.35;
    const Compliance state = settled(f, m, d, k, t / steps, steps);
    const double left = det::exp(-w * t) * (1.0 + w * t);
    CHECK(state.offset[0] == doctest::Approx(f[0] / k[0] * (1.0 - left)).epsilon(1e-12));
    CHECK(state.rate[0] == doctest::Approx(f[0] / m[0] * t * det::exp(-w * t)).epsilon(1e-12));
  }
  const Compliance rest = settled(f, m, d, k, 0.05, 400);
  CHECK((rest.offset - Vector6d(f.array() / k.array())).norm() < 1e-12);
  CHECK(rest.rate.norm() < 1e-12);
  // Without spring and damper a mass under a force: x = f t^2 / (2 m).
  const Vector6d none = Vector6d::Zero();
  const Compliance free = give_way({}, f, m, none, none, 2.0);
  CHECK((free.offset - Vector6d(2.0 * f.array() / m.array())).norm() < 1e-12);
}

TEST_CASE("compliance refuses what it cannot be") {
  const Vector6d one = Vector6d::Ones(), none = Vector6d::Zero();
  CHECK_THROWS_AS((void)give_way({}, one, none, one, one, 0.1), ArgumentError);
  CHECK_THROWS_AS((void)give_way({}, one, one, -one, one, 0.1), ArgumentError);
  CHECK_THROWS_AS((void)give_way({}, one, one, one, one, std::nan("")), ArgumentError);
  CHECK_THROWS_AS((void)give_way({}, one, Vector6d::Constant(1e-300), none, none, 1e10),
                  ArgumentError);
}
