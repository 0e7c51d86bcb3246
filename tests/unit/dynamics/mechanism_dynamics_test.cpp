// Trees of links with coupled joints.
#include "armlet/dynamics/mechanism_dynamics.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/dynamics/energy.hpp"
#include "armlet/dynamics/forward_dynamics.hpp"
#include "armlet/dynamics/identification.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/model/serial_arm.hpp"
#include "random_mass.hpp"

using namespace armlet;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

Vector3d random_vector(Random& random, double most) {
  Vector3d v;
  for (double& x : v) x = random.uniform(-most, most);
  return v;
}

VectorXd random_numbers(Random& random, Eigen::Index n, double most) {
  VectorXd v(n);
  for (double& x : v) x = random.uniform(-most, most);
  return v;
}

// A tree of up to 12 bodies with fixed, revolute and sliding joints; coupled: fewer actuators than
// joints, each driving several.
Mechanism random_tree(Random& random, bool coupled, bool rubs) {
  MechanismSpec spec;
  const int count = 3 + static_cast<int>(random.below(10));
  int joints = 0;
  for (int i = 0; i < count; ++i) {
    Body body{.name = "body" + std::to_string(i)};
    body.parent =
        i == 0 ? -1 : static_cast<int>(random.below(static_cast<std::uint64_t>(i) + 1)) - 1;
    body.joint = i == 0 ? BodyJoint::kRevolute : static_cast<BodyJoint>(random.below(3));
    body.T_parent_joint =
        make_translation(random_vector(random, 0.4)) *
        Eigen::AngleAxisd(random.uniform(-3.0, 3.0), random_vector(random, 1.0).normalized());
    body.axis = random_vector(random, 1.0).normalized();
    body.link = random_link(random);
    if (rubs) {
      body.link.friction = {
          .viscous = random.uniform(0.0, 1e-3), .coulomb_plus = 0.01, .coulomb_minus = -0.02};
    }
    joints += body.joint == BodyJoint::kFixed ? 0 : 1;
    spec.bodies.push_back(std::move(body));
  }
  const int actuators = coupled ? std::max(1, joints / 2) : joints;
  for (int a = 0; a < actuators; ++a)
    spec.actuators.push_back({.name = "motor" + std::to_string(a), .lower = -9.0, .upper = 9.0});
  if (coupled) {
    spec.coupling = MatrixXd::Zero(joints, actuators);
    for (int j = 0; j < joints; ++j) {
      spec.coupling(j, j % actuators) = random.uniform(0.5, 2.0);
      if (actuators > 1) spec.coupling(j, (j + 1) % actuators) = random.uniform(-1.0, 1.0);
    }
    spec.offset = random_numbers(random, joints, 1.0);
  }
  return Mechanism(std::move(spec));
}

struct Sample {
  VectorXd q, qd, qdd;
  Vector3d gravity;
};
Sample random_sample(Random& random, const Mechanism& tree) {
  const Eigen::Index n = tree.actuator_count();
  return {random_numbers(random, n, 2.0), random_numbers(random, n, 2.0),
          random_numbers(random, n, 4.0), random_vector(random, 9.81)};
}

}  // namespace

TEST_CASE("an arm and the mechanism made of it have the same dynamics") {
  Random random(41);
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    const Mechanism mechanism(mechanism_of(robot));
    for (int k = 0; k < 20; ++k) {
      VectorXd q(robot.n());
      for (int i = 0; i < robot.n(); ++i) q[i] = random.uniform(robot.lower()[i], robot.upper()[i]);
      const VectorXd qd = random_rates(random, robot.n()), qdd = random_rates(random, robot.n());
      const VectorXd tau = inverse_dynamics(robot, q, qd, qdd);
      const double scale = 1.0 + tau.norm();
      CHECK((inverse_dynamics(mechanism, {q, qd, qdd}, robot.gravity()) - tau).norm() <
            1e-10 * scale);
      const MatrixXd M = mass_matrix(robot, q);
      CHECK((mass_matrix(mechanism, q) - M).norm() < 1e-10 * (1.0 + M.norm()));
    }
  }
}

// The identities of one arm, over random trees with every mix of joints.
TEST_CASE("inverse dynamics is M qdd and the rest, and forward dynamics takes it back") {
  Random random(42);
  for (int k = 0; k < 600; ++k) {
    CAPTURE(k);
    const Mechanism tree = random_tree(random, k % 2 == 1, k % 3 == 0);
    const Sample at = random_sample(random, tree);
    const VectorXd tau = inverse_dynamics(tree, {at.q, at.qd, at.qdd}, at.gravity);
    const VectorXd still = VectorXd::Zero(at.q.size());
    const VectorXd bias = inverse_dynamics(tree, {at.q, at.qd, still}, at.gravity);
    const MatrixXd M = mass_matrix(tree, at.q);
    const double scale = 1.0 + tau.norm() + bias.norm();
    CHECK((M * at.qdd + bias - tau).norm() < 1e-11 * scale);
    const VectorXd back = forward_dynamics(tree, at.q, at.qd, tau, at.gravity);
    const double condition = M.norm() * M.inverse().norm();
    CHECK((back - at.qdd).norm() < 1e-13 * condition * scale);
  }
}

// Without friction power is the change of the energy: qd' tau = d/dt (T + V), by central
// differences along q + qd t + qdd t^2 / 2.
TEST_CASE("the power of the actuators is what the energy gains") {
  Random random(43);
  for (int k = 0; k < 400; ++k) {
    CAPTURE(k);
    const Mechanism tree = random_tree(random, k % 2 == 1, false);
    const Sample at = random_sample(random, tree);
    const auto energy = [&](double t) {
      const VectorXd q = at.q + t * at.qd + 0.5 * t * t * at.qdd, qd = at.qd + t * at.qdd;
      return kinetic_energy(tree, q, qd) + potential_energy(tree, q, at.gravity);
    };
    constexpr double h = 1e-4;
    const double change =
        (8.0 * (energy(h) - energy(-h)) - (energy(2.0 * h) - energy(-2.0 * h))) / (12.0 * h);
    const double power = at.qd.dot(inverse_dynamics(tree, {at.q, at.qd, at.qdd}, at.gravity));
    CHECK(std::abs(change - power) < 1e-7 * (1.0 + std::abs(energy(0.0)) + std::abs(power)));
    // Gravity alone: minus the slope of the potential energy.
    const VectorXd g = gravity_forces(tree, at.q, at.gravity);
    for (Eigen::Index i = 0; i < at.q.size(); ++i) {
      VectorXd above = at.q, below = at.q;
      above[i] += h;
      below[i] -= h;
      const double slope =
          (potential_energy(tree, above, at.gravity) - potential_energy(tree, below, at.gravity)) /
          (2.0 * h);
      CHECK(std::abs(slope - g[i]) < 1e-5 * (1.0 + g.norm()));
    }
  }
}

TEST_CASE("inverse dynamics of a tree is its regressor times its parameters") {
  Random random(44);
  for (int k = 0; k < 600; ++k) {
    CAPTURE(k);
    const Mechanism tree = random_tree(random, k % 2 == 1, k % 3 == 0);
    const Sample at = random_sample(random, tree);
    const MechanismMotion motion = {at.q, at.qd, at.qdd};
    const VectorXd tau = inverse_dynamics(tree, motion, at.gravity);
    const MatrixXd Y = dynamics_regressor(tree, motion, at.gravity);
    const VectorXd p = dynamic_parameters(tree);
    // What is added up, which may be larger than the sum.
    const double scale = 1.0 + (Y.cwiseAbs() * p.cwiseAbs()).norm();
    CHECK((Y * p - tau).norm() < 1e-12 * scale);
    // Nothing in it depends on the masses: that of another mechanism of the same geometry is the
    // same.
    MechanismSpec heavier = tree.spec();
    for (Body& body : heavier.bodies) {
      body.link.mass *= 2.0;
      body.link.inertia *= 2.0;
    }
    const Mechanism other(heavier);
    CHECK((dynamics_regressor(other, motion, at.gravity) - Y).norm() < 1e-12 * (1.0 + Y.norm()));
    CHECK((Y * dynamic_parameters(other) - inverse_dynamics(other, motion, at.gravity)).norm() <
          2e-12 * scale);
  }
}

TEST_CASE("the regressor of an arm and of the mechanism made of it are the same") {
  Random random(45);
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    const Mechanism mechanism(mechanism_of(robot));
    VectorXd q(robot.n());
    for (int i = 0; i < robot.n(); ++i) q[i] = random.uniform(robot.lower()[i], robot.upper()[i]);
    const VectorXd qd = random_rates(random, robot.n()), qdd = random_rates(random, robot.n());
    const VectorXd tau = dynamics_regressor(mechanism, {q, qd, qdd}, robot.gravity()) *
                         dynamic_parameters(mechanism);
    const VectorXd known = dynamics_regressor(robot, q, qd, qdd) * dynamic_parameters(robot);
    CHECK((tau - known).norm() < 1e-10 * (1.0 + known.norm()));
  }
}

TEST_CASE("a payload is a body that is fixed to the tip") {
  Random random(46);
  for (int k = 0; k < 300; ++k) {
    CAPTURE(k);
    MechanismSpec spec = random_tree(random, k % 2 == 1, k % 3 == 0).spec();
    const int carrier = static_cast<int>(random.below(spec.bodies.size()));
    const Eigen::Isometry3d T_body_tip =
        make_translation(random_vector(random, 0.3)) *
        Eigen::AngleAxisd(random.uniform(-3.0, 3.0), random_vector(random, 1.0).normalized());
    spec.tips.push_back({.name = "hand", .body = carrier, .T_body_tip = T_body_tip});
    const Link load = random_link(random);
    const Payload payload{.mass = load.mass, .com = load.com, .inertia = load.inertia};
    const Mechanism loaded = with_payload(Mechanism(spec), "hand", payload);
    // Behind the others, so that the order of the joints stays.
    spec.bodies.push_back({.name = "load",
                           .parent = carrier,
                           .T_parent_joint = T_body_tip,
                           .link = {.mass = load.mass, .com = load.com, .inertia = load.inertia}});
    const Mechanism merged(spec);
    const Sample at = random_sample(random, merged);
    const MechanismMotion motion = {at.q, at.qd, at.qdd};
    const VectorXd tau = inverse_dynamics(merged, motion, at.gravity);
    CHECK((inverse_dynamics(loaded, motion, at.gravity) - tau).norm() < 1e-12 * (1.0 + tau.norm()));
    const MatrixXd M = mass_matrix(merged, at.q);
    CHECK((mass_matrix(loaded, at.q) - M).norm() < 1e-12 * (1.0 + M.norm()));
  }
}

TEST_CASE("a payload on no tip, or of no body, is refused") {
  Random random(47);
  const Mechanism tree = random_tree(random, false, false);
  CHECK_THROWS_AS((void)with_payload(tree, "hand", {.mass = 1.0}), ArgumentError);
  MechanismSpec spec = tree.spec();
  spec.tips.push_back({.name = "hand", .body = 0});
  CHECK_THROWS_AS((void)with_payload(Mechanism(spec), "hand", {.mass = -100.0}), ArgumentError);
  CHECK_THROWS_AS((void)with_payload(Mechanism(spec), "hand", {.mass = NAN}), ArgumentError);
}

// Two equal fingers that one motor closes against each other, 0.1 kg at 50 mm each.
TEST_CASE("what a motor drives twice counts twice") {
  MechanismSpec spec;
  for (int i = 0; i < 2; ++i) {
    Body finger{.name = i == 0 ? "left" : "right", .joint = BodyJoint::kRevolute};
    finger.link.mass = 0.1;
    finger.link.com = {i == 0 ? 0.05 : -0.05, 0.0, 0.0};
    spec.bodies.push_back(finger);
  }
  spec.inertia_check = InertiaCheck::kPublished;
  spec.actuators = {{.name = "motor", .lower = -1.0, .upper = 1.0}};
  spec.coupling = Eigen::Vector2d(1.0, -1.0);
  spec.offset = Eigen::Vector2d::Zero();
  const Mechanism hand(spec);
  const VectorXd q = VectorXd::Zero(1);
  CHECK(mass_matrix(hand, q)(0, 0) == doctest::Approx(2.0 * 0.1 * 0.05 * 0.05).epsilon(1e-14));
  // Across the axes gravity pulls both fingers down: 2 * 0.1 * 9.81 * 0.05 N m.
  CHECK(gravity_forces(hand, q, {0.0, -9.81, 0.0})[0] ==
        doctest::Approx(2.0 * 0.1 * 9.81 * 0.05).epsilon(1e-14));
}

TEST_CASE("what cannot be is refused with the name of the actuator") {
  MechanismSpec spec;
  spec.bodies.push_back({.name = "shell", .joint = BodyJoint::kRevolute});
  spec.actuators = {{.name = "motor", .lower = -1.0, .upper = 1.0}};
  const Mechanism empty(spec);
  const VectorXd one = VectorXd::Ones(1);
  CHECK_THROWS_WITH_AS((void)forward_dynamics(empty, one, one, one, Vector3d::Zero()),
                       doctest::Contains("nothing resists actuator `motor`"), ArgumentError);
  CHECK_THROWS_AS((void)mass_matrix(empty, VectorXd::Ones(2)), ArgumentError);
  CHECK_THROWS_AS((void)gravity_forces(empty, VectorXd::Constant(1, NAN), Vector3d::Zero()),
                  ArgumentError);
}
