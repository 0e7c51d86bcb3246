// The functions of dynamics take no memory from the heap.
#include <doctest/doctest.h>

#include "armlet/dynamics/batch.hpp"
#include "armlet/dynamics/forward_dynamics.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "armlet/dynamics/simulation.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/model/joint_coupling.hpp"
#include "count_allocations.hpp"
#include "random_mass.hpp"

using namespace armlet;
using Eigen::VectorXd;

TEST_CASE("forces and accelerations of arms of 1 to 12 joints allocate nothing") {
  Random random(9);
  for (int n = 1; n <= kMaxJoints; ++n) {
    CAPTURE(n);
    RobotSpec spec = random_heavy_arm(random, n).spec();
    for (Link& link : spec.links) link.friction = {1e-4, 0.02, -0.03, 0.05, 0.1};
    const Robot robot(spec);
    const VectorXd q = random_values(random, n), qd = random_rates(random, n),
                   qdd = random_rates(random, n);
    (void)gravity_forces(robot, q);  // works out the plan of the arm
    const long before = allocations;
    double sum = inverse_dynamics(robot, q, qd, qdd).sum() + bias_forces(robot, q, qd).sum() +
                 gravity_forces(robot, q).sum() + coriolis_forces(robot, q, qd).sum() +
                 friction_forces(robot, qd).sum() + mass_matrix(robot, q).sum() +
                 wrench_forces(robot, q, Vector6d::Ones()).sum() +
                 forward_dynamics(robot, q, qd, qdd).sum();
    CHECK(allocations == before);
    CHECK(sum == sum);
  }
}

TEST_CASE("arms with rows that copy others allocate nothing either") {
  Random random(11);
  for (int rows = 3; rows <= kMaxJoints; ++rows) {
    CAPTURE(rows);
    RobotSpec spec = random_heavy_arm(random, rows).spec();
    spec.home = {};
    spec.joints[0].kind = spec.joints[2].kind = JointKind::kRevolute;
    spec.joints[2].drive = {.of = 0, .ratio = -0.5, .offset = 0.1};
    spec.links[2].motor_inertia = 0.0;
    spec.links[2].friction = {};
    const Robot robot(spec);
    REQUIRE(robot.coupling() != nullptr);
    const int n = robot.n();
    const VectorXd q = random_values(random, n), qd = random_rates(random, n),
                   qdd = random_rates(random, n);
    (void)gravity_forces(robot, q);  // works out the plan of the arm
    const long before = allocations;
    double sum = forward(robot, q).matrix().sum() + inverse_dynamics(robot, q, qd, qdd).sum() +
                 bias_forces(robot, q, qd).sum() + gravity_forces(robot, q).sum() +
                 coriolis_forces(robot, q, qd).sum() + friction_forces(robot, qd).sum() +
                 mass_matrix(robot, q).sum() + wrench_forces(robot, q, Vector6d::Ones()).sum() +
                 forward_dynamics(robot, q, qd, qdd).sum();
    CHECK(allocations == before);
    CHECK(sum == sum);
  }
}

TEST_CASE("simulation allocates nothing, whatever its joints run against") {
  Random random(10);
  for (int n = 1; n <= 6; ++n) {
    CAPTURE(n);
    RobotSpec spec = random_heavy_arm(random, n).spec();
    for (Link& link : spec.links) link.friction = {1e-4, 0.02, -0.03, 0.05, 0.1};
    for (Joint& joint : spec.joints) {
      joint.lower = -0.5;
      joint.upper = 0.5;
    }
    ArmSimulation arm(std::make_shared<const Robot>(spec), VectorXd::Zero(n),
                      random_rates(random, n), {.restitution = 0.3});
    const VectorXd tau = random_rates(random, n);
    REQUIRE(arm.advance(tau, 0.0).status == SimulationStatus::kDone);
    const long before = allocations;
    const SimulationOutcome outcome = arm.advance(tau, 1.0);
    CHECK(allocations == before);
    CHECK(outcome.status == SimulationStatus::kDone);
    CHECK(arm.event_count() > 0);
  }
}
