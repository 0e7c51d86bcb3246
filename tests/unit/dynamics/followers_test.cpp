// Arms with links whose joints copy joints of the arm: a balancing cylinder and what it carries.

#include <doctest/doctest.h>

#include "armlet/core/random.hpp"
#include "armlet/dynamics/batch.hpp"
#include "armlet/dynamics/coriolis.hpp"
#include "armlet/dynamics/energy.hpp"
#include "armlet/dynamics/forward_dynamics.hpp"
#include "armlet/dynamics/identification.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "armlet/kinematics/mechanism_forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/serial_arm.hpp"

using namespace armlet;

namespace {

Link heavy(double mass, const Eigen::Vector3d& com) {
  Link link;
  link.mass = mass;
  link.com = com;
  link.inertia = Eigen::Vector3d(0.9, 1.0, 1.1).asDiagonal();
  return link;
}

// Three joints, a cylinder on link 1 that follows joint 2, a piston that follows joint 3 and a
// weight that is fixed to the piston.
Mechanism balanced() {
  MechanismSpec spec;
  spec.name = "balanced";
  const auto add = [&](const char* link, const char* joint, int parent, BodyJoint kind,
                       const Eigen::Vector3d& p, const Eigen::Vector3d& axis, const Link& body) {
    spec.bodies.push_back({.name = link,
                           .joint_name = joint,
                           .parent = parent,
                           .joint = kind,
                           .T_parent_joint = make_translation(p),
                           .axis = axis,
                           .link = body});
  };
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  constexpr BodyJoint kTurns = BodyJoint::kRevolute;
  add("l1", "j1", -1, kTurns, {0.1, 0, 0.8}, z, heavy(30, {0, 0.1, 0}));
  add("l2", "j2", 0, kTurns, {0.3, 0, 0}, y, heavy(100, {0, 0, 0.5}));
  add("l3", "j3", 1, kTurns, {0, 0, 1.1}, y, heavy(80, {0.6, 0, 0}));
  add("cylinder", "jc", 0, kTurns, {-0.4, 0, -0.2}, y, heavy(60, {0.5, 0, 0.1}));
  add("piston", "jp", 3, BodyJoint::kPrismatic, {0.5, 0, 0}, {1, 0, 1}, heavy(10, {0.1, 0, 0}));
  add("weight", "jw", 4, BodyJoint::kFixed, {0.1, 0.2, 0.3}, z, heavy(5, {0, 0, 0.1}));
  spec.bodies[3].link.friction = {.viscous = 2.0, .coulomb_plus = 3.0, .coulomb_minus = -3.0};
  for (const char* name : {"j1", "j2", "j3"})
    spec.actuators.push_back({.name = name, .lower = -3, .upper = 3});
  spec.coupling = Eigen::MatrixXd::Zero(5, 3);
  spec.coupling.topRows<3>().setIdentity();
  spec.coupling(3, 1) = -0.34;
  spec.coupling(4, 2) = 0.2;
  spec.offset = Eigen::VectorXd::Zero(5);
  spec.offset[3] = 0.1;
  return Mechanism(spec);
}

Robot arm_of(const Mechanism& mechanism) {
  const Result<RobotSpec> spec = serial_arm(mechanism, "l3");
  REQUIRE(spec.ok());
  REQUIRE(spec->notes.empty());
  const Eigen::Isometry3d base = pose_from_rpy({0.3, -0.2, 0.7}, {0.4, 0.5, 0.6});
  return Robot(*spec).with_base(base);
}

// From the poses of all bodies alone.
double potential(const Robot& robot, const Mechanism& m, const Eigen::VectorXd& q) {
  const auto frames = body_frames(m, q);
  double energy = 0.0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Link& link = m.bodies()[i].link;
    energy -= link.mass * robot.gravity().dot(robot.T_world_base() * (frames[i] * link.com));
  }
  return energy;
}

Eigen::VectorXd random3(Random& random, double most) {
  return Eigen::Vector3d(random.uniform(-most, most), random.uniform(-most, most),
                         random.uniform(-most, most));
}

}  // namespace

TEST_CASE("gravity of an arm with followers is the slope of the energy of all its links") {
  const Mechanism m = balanced();
  const Robot robot = arm_of(m);
  REQUIRE(robot.spec().followers != nullptr);
  Random random(42);
  constexpr double kStep = 1e-4;
  for (int k = 0; k < 50; ++k) {
    const Eigen::VectorXd q = random3(random, 3.0);
    CHECK(potential_energy(robot, q) == doctest::Approx(potential(robot, m, q)).epsilon(1e-12));
    const JointVector tau = gravity_forces(robot, q);
    for (int j = 0; j < 3; ++j) {
      const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(3, j);
      const double slope =
          (potential(robot, m, q + step) - potential(robot, m, q - step)) / (2 * kStep);
      CHECK(tau[j] == doctest::Approx(slope).epsilon(1e-6).scale(1000));
    }
  }
}

TEST_CASE("the equation of motion of an arm with followers is that of the tree") {
  const Mechanism m = balanced();
  const Robot robot = arm_of(m);
  const Robot without = [&] {
    RobotSpec spec = robot.spec();
    spec.followers = nullptr;
    return Robot(spec);
  }();
  Random random(43);
  for (int k = 0; k < 50; ++k) {
    const Eigen::VectorXd q = random3(random, 3.0), qd = random3(random, 2.0),
                          qdd = random3(random, 4.0);
    const JointMatrix M = mass_matrix(robot, q);
    const JointVector tau = inverse_dynamics(robot, q, qd, qdd);
    const JointVector sum = M * qdd + bias_forces(robot, q, qd) + friction_forces(robot, qd);
    CHECK((tau - sum).norm() < 1e-9 * tau.norm());
    CHECK((tau - inverse_dynamics(without, q, qd, qdd)).norm() > 1.0);
    CHECK((forward_dynamics(robot, q, qd, tau) - qdd).norm() < 1e-9);
    CHECK((articulated_body(robot, q, qd, tau) - qdd).norm() < 1e-9);
    CHECK(coriolis_forces(robot, q, qd)
              .isApprox(bias_forces(robot, q, qd) - gravity_forces(robot, q), 1e-9));
    CHECK((coriolis_matrix(robot, q, qd) * qd).isApprox(coriolis_forces(robot, q, qd), 1e-9));
    // Energy: the power of the joints is the rate of kinetic energy, for M' - 2 C is skew.
    constexpr double kStep = 1e-5;
    const Eigen::MatrixXd rate =
        (mass_matrix(robot, q + kStep * qd) - mass_matrix(robot, q - kStep * qd)) / (2 * kStep);
    const Eigen::MatrixXd N = rate - 2.0 * coriolis_matrix(robot, q, qd);
    CHECK((N + N.transpose()).norm() < 1e-5 * (1.0 + rate.norm()));
    Eigen::VectorXd batch(3);
    inverse_dynamics_batch(robot, {q.data(), 3}, {qd.data(), 3}, {qdd.data(), 3},
                           {batch.data(), 3});
    CHECK(batch.isApprox(tau, 1e-12));
  }
}

TEST_CASE("the regressor of an arm with followers gives its forces, and its base parameters too") {
  Random random(44);
  const Robot robot = arm_of(balanced());
  // Three links of the arm; the cylinder, the piston and the weight beside it.
  const Eigen::VectorXd p = dynamic_parameters(robot);
  REQUIRE(p.size() == 6 * kLinkParameters);
  const BaseParameters base = base_parameters(robot);
  const Eigen::VectorXd p_base = base.grouping * p;
  CHECK(static_cast<Eigen::Index>(base.columns.size()) < p.size());
  // Some of them belong to the links beside the arm: the arm alone does not explain the forces.
  CHECK(base.columns.back() >= 3 * kLinkParameters);
  for (int k = 0; k < 100; ++k) {
    const Eigen::VectorXd q = random3(random, 3.0), qdd = random3(random, 4.0);
    const Eigen::VectorXd qd = k % 4 == 0 ? Eigen::VectorXd::Zero(3) : random3(random, 2.0);
    const JointVector tau = inverse_dynamics(robot, q, qd, qdd);
    const Eigen::MatrixXd Y = dynamics_regressor(robot, q, qd, qdd);
    CHECK((Y * p - tau).norm() < 1e-10 * tau.norm());
    CHECK((Y(Eigen::all, base.columns) * p_base - tau).norm() < 1e-8 * tau.norm());
    const Eigen::VectorXd any = Eigen::VectorXd::NullaryExpr(
        p.size(), [&](Eigen::Index) { return random.uniform(-1.0, 1.0); });
    const Eigen::VectorXd forces = Y * any;
    CHECK((Y(Eigen::all, base.columns) * (base.grouping * any) - forces).norm() <
          1e-7 * (1.0 + forces.norm()));
  }
}

TEST_CASE("derivatives of the forces include the followers") {
  const Robot robot = arm_of(balanced());
  const Eigen::Vector3d q(0.3, -0.4, 0.9), qd(0.5, 0.7, -0.6), qdd(1.0, -2.0, 0.5);
  const ForceDerivatives D = inverse_dynamics_derivatives(robot, q, qd, qdd);
  constexpr double kStep = 1e-5;
  for (int j = 0; j < 3; ++j) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(j);
    const JointVector by_q =
        (inverse_dynamics(robot, q + step, qd, qdd) - inverse_dynamics(robot, q - step, qd, qdd)) /
        (2 * kStep);
    const JointVector by_qd =
        (inverse_dynamics(robot, q, qd + step, qdd) - inverse_dynamics(robot, q, qd - step, qdd)) /
        (2 * kStep);
    CHECK((D.by_q.col(j) - by_q).norm() < 1e-5 * (1.0 + by_q.norm()));
    CHECK((D.by_qd.col(j) - by_qd).norm() < 1e-5 * (1.0 + by_qd.norm()));
  }
}

TEST_CASE("chains of the same length leave the end open, also if one copies the other") {
  const Result<RobotSpec> open = serial_arm(balanced());
  REQUIRE_FALSE(open.ok());
  for (const char* part : {"`l3` (3 joints: j1, j2, j3)", "`weight` (3 joints: j1, jc, jp)",
                           "`l1` (1 joint: j1), where they meet"})
    CHECK(open.error().message.find(part) != std::string::npos);
}

TEST_CASE("the longest chain is the arm unless a joint beside it has a motor") {
  MechanismSpec spec = balanced().spec();
  spec.bodies[4].joint = BodyJoint::kFixed;
  spec.coupling.conservativeResize(4, 3);
  spec.offset.conservativeResize(4);
  const Result<RobotSpec> arm = serial_arm(Mechanism(spec));
  REQUIRE(arm.ok());
  CHECK(arm->joints.size() == 3);
  CHECK(arm->followers != nullptr);
  REQUIRE(arm->notes.size() == 1);
  CHECK(arm->notes[0].find("`l3` (3 joints: j1, j2, j3)") != std::string::npos);

  spec.actuators.push_back({.name = "jc", .lower = 0, .upper = 1});
  spec.coupling.conservativeResize(4, 4);
  spec.coupling.col(3).setZero();
  spec.coupling.row(3).setZero();
  spec.coupling(3, 3) = 1.0;
  const Result<RobotSpec> open = serial_arm(Mechanism(spec));
  REQUIRE_FALSE(open.ok());
  for (const char* part : {"`l1`", "`l3` (3 joints: j1, j2, j3)", "`weight` (2 joints: j1, jc)"})
    CHECK(open.error().message.find(part) != std::string::npos);
  CHECK(serial_arm(Mechanism(spec), "l3").ok());
}
