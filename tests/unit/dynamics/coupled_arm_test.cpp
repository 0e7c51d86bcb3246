// Arms with joints that copy others, against the trees that they are read from.

#include <doctest/doctest.h>

#include "armlet/dynamics/batch.hpp"
#include "armlet/dynamics/coriolis.hpp"
#include "armlet/dynamics/energy.hpp"
#include "armlet/dynamics/forward_dynamics.hpp"
#include "armlet/dynamics/identification.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "armlet/dynamics/mechanism_dynamics.hpp"
#include "armlet/dynamics/simulation.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/kinematics/mechanism_forward.hpp"
#include "armlet/model/joint_coupling.hpp"
#include "armlet/model/serial_arm.hpp"
#include "random_mass.hpp"

using namespace armlet;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// An arm, the tree that it was read from, and gravity in the axes of its base.
struct Pair {
  Mechanism tree;
  Robot arm;
  Vector3d gravity;
};

Pair random_pair(Random& random) {
  const int n = 1 + static_cast<int>(random.below(5)),
            copies = 1 + static_cast<int>(random.below(3));
  Mechanism tree = random_coupled_chain(random, n, copies);
  const Result<RobotSpec> spec = serial_arm(tree, "tool");
  REQUIRE(spec.ok());
  Robot arm = Robot(*spec).with_base(random_step(random));
  REQUIRE(arm.n() == n);
  REQUIRE(arm.rows() == n + copies);
  const Vector3d gravity = arm.T_world_base().linear().transpose() * arm.gravity();
  return {std::move(tree), std::move(arm), gravity};
}

double error_of(const MatrixXd& a, const MatrixXd& b) { return (a - b).norm() / (1.0 + b.norm()); }

}  // namespace

TEST_CASE("forces and inertia of an arm with copying joints are those of its tree") {
  Random random(7001);
  for (int k = 0; k < 150; ++k) {
    const Pair pair = random_pair(random);
    const auto& [tree, arm, gravity] = pair;
    const int n = arm.n();
    const VectorXd q = random_rates(random, n), qd = random_rates(random, n),
                   qdd = random_rates(random, n);
    const VectorXd tau = inverse_dynamics(tree, {q, qd, qdd}, gravity);
    CHECK(error_of(inverse_dynamics(arm, q, qd, qdd), tau) < 1e-11);
    CHECK(error_of(gravity_forces(arm, q), gravity_forces(tree, q, gravity)) < 1e-11);
    CHECK(error_of(mass_matrix(arm, q), mass_matrix(tree, q)) < 1e-11);
    const VectorXd still = VectorXd::Zero(n);
    CHECK(error_of(bias_forces(arm, q, qd) + friction_forces(arm, qd),
                   inverse_dynamics(tree, {q, qd, still}, gravity)) < 1e-11);
    CHECK(error_of(coriolis_matrix(arm, q, qd) * qd, coriolis_forces(arm, q, qd)) < 1e-10);
    CHECK(error_of(forward_dynamics(arm, q, qd, tau), qdd) < 1e-8);
    CHECK(error_of(articulated_body(arm, q, qd, tau), qdd) < 1e-8);
    CHECK(std::abs(kinetic_energy(arm, q, qd) - kinetic_energy(tree, q, qd)) < 1e-9);
    CHECK(error_of(dynamics_regressor(arm, q, qd, qdd) * dynamic_parameters(arm), tau) < 1e-10);
  }
}

TEST_CASE(
    "gravity of an arm with copying joints is the slope of its energy, and M' - 2 C is skew") {
  Random random(7002);
  constexpr double kStep = 1e-5;
  for (int k = 0; k < 60; ++k) {
    const Pair pair = random_pair(random);
    const Robot& arm = pair.arm;
    const VectorXd q = random_rates(random, arm.n()), qd = random_rates(random, arm.n()),
                   qdd = random_rates(random, arm.n());
    const ForceDerivatives D = inverse_dynamics_derivatives(arm, q, qd, qdd);
    for (int j = 0; j < arm.n(); ++j) {
      const VectorXd step = kStep * VectorXd::Unit(arm.n(), j);
      const double slope =
          (potential_energy(arm, q + step) - potential_energy(arm, q - step)) / (2 * kStep);
      CHECK(gravity_forces(arm, q)[j] == doctest::Approx(slope).epsilon(1e-6).scale(10));
      const VectorXd by_q =
          (inverse_dynamics(arm, q + step, qd, qdd) - inverse_dynamics(arm, q - step, qd, qdd)) /
          (2 * kStep);
      const VectorXd by_qd =
          (inverse_dynamics(arm, q, qd + step, qdd) - inverse_dynamics(arm, q, qd - step, qdd)) /
          (2 * kStep);
      CHECK(error_of(D.by_q.col(j), by_q) < 1e-5);
      CHECK(error_of(D.by_qd.col(j), by_qd) < 1e-5);
    }
    const MatrixXd rate =
        (mass_matrix(arm, q + kStep * qd) - mass_matrix(arm, q - kStep * qd)) / (2 * kStep);
    const MatrixXd N = rate - 2.0 * coriolis_matrix(arm, q, qd);
    CHECK((N + N.transpose()).norm() < 1e-5 * (1.0 + rate.norm()));
  }
}

TEST_CASE("a load at the tool point, wrenches and batches count joints that copy") {
  Random random(7003);
  for (int k = 0; k < 60; ++k) {
    const Pair pair = random_pair(random);
    const auto& [tree, arm, gravity] = pair;
    const int n = arm.n();
    const Robot loaded = arm.with_payload({.mass = 2.0, .com = arm.T_flange_tool().translation()});
    const Mechanism heavy = with_payload(tree, "tool", {.mass = 2.0});
    constexpr Eigen::Index kCount = 7;
    using Lanes = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    for (const Eigen::Index count : {Eigen::Index{1}, kCount}) {
      Lanes q(n, count), qd(n, count), qdd(n, count), tau(n, count);
      for (Lanes* each : {&q, &qd, &qdd})
        for (Eigen::Index c = 0; c < count; ++c) each->col(c) = random_rates(random, n);
      const auto span = [&](const Lanes& m) {
        return std::span(m.data(), static_cast<std::size_t>(m.size()));
      };
      inverse_dynamics_batch(loaded, span(q), span(qd), span(qdd),
                             {tau.data(), static_cast<std::size_t>(tau.size())});
      for (Eigen::Index c = 0; c < count; ++c) {
        const VectorXd expected =
            inverse_dynamics(heavy, {q.col(c), qd.col(c), qdd.col(c)}, gravity);
        CHECK(error_of(inverse_dynamics(loaded, q.col(c), qd.col(c), qdd.col(c)), expected) <
              1e-11);
        CHECK(error_of(tau.col(c), expected) < 1e-11);
      }
    }
    const VectorXd q = random_rates(random, n);
    Vector6d wrench;
    for (double& x : wrench) x = random.uniform(-5.0, 5.0);
    CHECK(error_of(wrench_forces(arm, q, wrench), jacobian(arm, q).transpose() * wrench) < 1e-11);
  }
}

TEST_CASE("a frictionless arm with copying joints keeps its energy while it falls") {
  Random random(7004);
  for (int k = 0; k < 10; ++k) {
    const Pair pair = random_pair(random);
    RobotSpec spec = pair.arm.spec();
    spec.followers = nullptr;
    for (Link& link : spec.links) link.friction = {};
    for (Joint& joint : spec.joints) joint.lower = -(joint.upper = 1e3);
    const auto arm = std::make_shared<const Robot>(spec);
    const VectorXd q = random_rates(random, arm->n()), still = VectorXd::Zero(arm->n());
    ArmSimulation simulation(arm, q, still, {.step = 1e-3});
    REQUIRE(simulation.advance(still, 0.3).status == SimulationStatus::kDone);
    const double energy = kinetic_energy(*arm, simulation.q(), simulation.qd());
    CHECK(energy > 0.0);
    CHECK(std::abs(simulation.energy_drift()) < 1e-5 * (1.0 + energy));
  }
}

TEST_CASE("base parameters explain the forces of an arm with copying joints") {
  Random random(7005);
  for (int k = 0; k < 5; ++k) {
    const Pair pair = random_pair(random);
    const Robot& arm = pair.arm;
    const VectorXd p = dynamic_parameters(arm);
    const BaseParameters base = base_parameters(arm);
    const VectorXd p_base = base.grouping * p;
    for (int trial = 0; trial < 10; ++trial) {
      const VectorXd q = random_rates(random, arm.n()), qd = random_rates(random, arm.n()),
                     qdd = random_rates(random, arm.n());
      const MatrixXd Y = dynamics_regressor(arm, q, qd, qdd);
      CHECK(error_of(Y(Eigen::all, base.columns) * p_base, inverse_dynamics(arm, q, qd, qdd)) <
            1e-6);
    }
  }
}
