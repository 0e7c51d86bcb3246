#include "armlet/dynamics/simulation.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "armlet/core/error.hpp"
#include "armlet/dynamics/energy.hpp"
#include "armlet/model/catalog.hpp"
#include "random_mass.hpp"

using namespace armlet;
using Eigen::VectorXd;

namespace {

std::shared_ptr<const Robot> shared(RobotSpec spec) {
  return std::make_shared<const Robot>(std::move(spec));
}

// A mass on a rail: along the world's x axis, or upright.
RobotSpec slider(double mass, bool upright) {
  RobotSpec spec;
  Joint joint;
  joint.kind = JointKind::kPrismatic;
  joint.lower = upright ? 0.0 : -10.0;
  joint.upper = 10.0;
  spec.joints = {joint};
  spec.links.resize(1);
  spec.links[0].mass = mass;
  spec.gravity = upright ? Eigen::Vector3d(0.0, 0.0, -9.81) : Eigen::Vector3d::Zero();
  return spec;
}

VectorXd one(double value) { return VectorXd::Constant(1, value); }

// The Puma 560 without friction and limits.
std::shared_ptr<const Robot> free_puma() {
  RobotSpec spec = make_robot("puma560")->spec();
  for (Link& link : spec.links) link.friction = {};
  for (Joint& joint : spec.joints) {
    joint.lower = -1e3;
    joint.upper = 1e3;
  }
  return shared(std::move(spec));
}

// The largest drift of the energy in 5 s of falling from qn.
double worst_drift(OdeMethod method, double step) {
  const double pi = std::numbers::pi;
  VectorXd qn(6);
  qn << 0.0, pi / 4, pi, 0.0, pi / 4, 0.0;
  const VectorXd zero = VectorXd::Zero(6);
  ArmSimulation puma(free_puma(), qn, zero, {.method = method, .step = step});
  double worst = 0.0;
  for (int k = 0; k < std::lround(5.0 / step); ++k) {
    REQUIRE(puma.advance(zero, step).status == SimulationStatus::kDone);
    worst = std::max(worst, std::abs(puma.energy_drift()));
  }
  return worst;
}

}  // namespace

// The numbers are those of an independent implementation, to their printed digits.
TEST_CASE("the energy of a falling Puma 560 drifts as its methods let it") {
  struct Row {
    OdeMethod method;
    double coarse, fine;  // J, with steps of 10 ms and of 1 ms
  };
  const Row rows[] = {{OdeMethod::kEuler, 11.8, 1.36},
                      {OdeMethod::kSymplectic, 1.79, 0.17},
                      {OdeMethod::kEulerRichardson, 1.2e-2, 1.4e-4},
                      {OdeMethod::kRungeKutta4, 3.5e-6, 3.8e-10}};
  for (const Row& row : rows) {
    CAPTURE(ode_method_names()[static_cast<std::size_t>(row.method)]);
    CHECK(worst_drift(row.method, 1e-2) == doctest::Approx(row.coarse).epsilon(0.05));
    CHECK(worst_drift(row.method, 1e-3) == doctest::Approx(row.fine).epsilon(0.05));
  }
  CHECK(worst_drift(OdeMethod::kVerlet, 1e-3) < 1e-2);
  for (const OdeMethod method : {OdeMethod::kFehlberg45, OdeMethod::kDormandPrince45})
    CHECK(worst_drift(method, 1e-2) < 1e-4);
}

TEST_CASE("dry friction stops a mass after v m / F and holds it, at the instant to 1e-9 s") {
  RobotSpec spec = slider(2.0, false);
  spec.links[0].friction = {.coulomb_plus = 3.0, .coulomb_minus = -3.0};
  for (const OdeMethod method :
       {OdeMethod::kEuler, OdeMethod::kSymplectic, OdeMethod::kEulerRichardson,
        OdeMethod::kRungeKutta4, OdeMethod::kFehlberg45, OdeMethod::kDormandPrince45,
        OdeMethod::kVerlet}) {
    CAPTURE(static_cast<int>(method));
    ArmSimulation mass(shared(spec), one(0.0), one(1.0), {.method = method, .step = 0.01});
    REQUIRE(mass.advance(one(0.0), 2.0).status == SimulationStatus::kDone);
    REQUIRE(mass.event_count() == 1);
    CHECK(mass.events()[0].kind == SimulationEventKind::kStick);
    CHECK(std::abs(mass.events()[0].t - 2.0 / 3.0) < 1e-9);
    CHECK(mass.qd()[0] == 0.0);
    if (method != OdeMethod::kEuler && method != OdeMethod::kSymplectic) {
      CHECK(std::abs(mass.q()[0] - 1.0 / 3.0) < 1e-9);
      CHECK(std::abs(mass.energy_drift()) < 1e-12);
    }
    // Up to 3 N it stands for ever, without creeping; beyond, it moves.
    const double stood = mass.q()[0];
    REQUIRE(mass.advance(one(2.999), 10.0).status == SimulationStatus::kDone);
    CHECK(mass.q()[0] == stood);
    REQUIRE(mass.advance(one(-3.5), 1.0).status == SimulationStatus::kDone);
    CHECK(mass.events().back().kind == SimulationEventKind::kSlip);
    CHECK(mass.qd()[0] == doctest::Approx(-0.25).epsilon(1e-9));
  }
}

TEST_CASE("a mass that falls on its stop bounces when it should and comes to rest") {
  ArmSimulation ball(shared(slider(1.0, true)), one(1.0), one(0.0), {.restitution = 0.5});
  REQUIRE(ball.advance(one(0.0), 2.0).status == SimulationStatus::kDone);
  double t = std::sqrt(2.0 / 9.81), v = 9.81 * t;
  REQUIRE(ball.events().size() > 10);
  for (std::size_t k = 0; k < 10; ++k) {
    CHECK(ball.events()[k].kind == SimulationEventKind::kStop);
    CHECK(std::abs(ball.events()[k].t - t) < 1e-9);
    CHECK(ball.events()[k].speed == doctest::Approx(-v).epsilon(1e-8));
    v *= 0.5;
    t += 2.0 * v / 9.81;
  }
  CHECK(ball.q()[0] == 0.0);
  CHECK(ball.qd()[0] == 0.0);
  CHECK(std::abs(ball.energy_drift()) < 1e-9);
  // Pulled up, it leaves.
  REQUIRE(ball.advance(one(10.81), 1.0).status == SimulationStatus::kDone);
  CHECK(ball.q()[0] == doctest::Approx(0.5).epsilon(1e-9));
}

TEST_CASE("an elastic impact of a moving arm keeps its energy; a dull one loses some") {
  Random random(8);
  for (int k = 0; k < 40; ++k) {
    const int n = 2 + k % 5;
    RobotSpec spec = random_heavy_arm(random, n).spec();
    for (Joint& joint : spec.joints) {
      joint.lower = -0.3;
      joint.upper = 0.3;
    }
    for (const double restitution : {1.0, 0.3}) {
      const auto robot = shared(spec);
      ArmSimulation arm(
          robot, VectorXd::Zero(n), random_rates(random, n),
          {.method = OdeMethod::kRungeKutta4, .step = 2e-4, .restitution = restitution});
      const double before =
          kinetic_energy(*robot, arm.q(), arm.qd()) + potential_energy(*robot, arm.q());
      REQUIRE(arm.advance(VectorXd::Zero(n), 0.3).status == SimulationStatus::kDone);
      const double after =
          kinetic_energy(*robot, arm.q(), arm.qd()) + potential_energy(*robot, arm.q());
      CHECK(std::abs(arm.energy_drift()) < 1e-5);
      if (restitution == 1.0) {
        CHECK(after == doctest::Approx(before).epsilon(1e-3));
      } else {
        CHECK(after < before + 1e-6);
      }
      CHECK((arm.q().array().abs() <= 0.3).all());
    }
  }
}

// Static friction above that of sliding: a mass that is drawn by a slow spring moves in jumps, and
// every jump begins where the spring reaches the static force.
TEST_CASE("a mass drawn by a spring sticks and slips") {
  RobotSpec spec = slider(1.0, false);
  spec.links[0].friction = {
      .coulomb_plus = 2.0, .coulomb_minus = -2.0, .static_torque = 3.0, .stribeck_speed = 1e-3};
  ArmSimulation mass(shared(spec), one(0.0), one(0.0), {.step = 1e-4});
  const double pull = 0.01, stiffness = 100.0, tick = 1e-3;
  double t = 0.0;
  for (int k = 0; k < 20'000; ++k, t += tick)
    REQUIRE(mass.advance(one(stiffness * (pull * t - mass.q()[0])), tick).status ==
            SimulationStatus::kDone);
  int slips = 0, sticks = 0;
  for (const SimulationEvent& event : mass.events()) {
    slips += event.kind == SimulationEventKind::kSlip;
    sticks += event.kind == SimulationEventKind::kStick;
    if (slips == 1 && sticks == 0) CHECK(std::abs(event.t - 3.0 / (stiffness * pull)) < 1.5 * tick);
  }
  CHECK(slips >= 5);
  CHECK(std::abs(slips - sticks) <= 1);
  // Undamped, each jump would take the force from 3 N to 1 N below that of sliding: 2 N in all.
  CHECK(slips == doctest::Approx((pull * t * stiffness - 3.0) / 2.0).epsilon(0.25));
}

TEST_CASE("what cannot be simulated is reported with the joint, and the state stays") {
  const auto expect = [](RobotSpec spec, const VectorXd& q, const VectorXd& qd,
                         const SimulationOptions& options, SimulationStatus status, int joint) {
    ArmSimulation arm(shared(std::move(spec)), q, qd, options);
    const SimulationOutcome outcome = arm.advance(VectorXd::Constant(q.size(), 1.0), 1.0);
    CHECK(outcome.status == status);
    CHECK(outcome.joint == joint);
    CHECK(arm.t() == outcome.t);
    CHECK(arm.q().allFinite());
    CHECK(arm.qd().allFinite());
    if (outcome.t == 0.0) CHECK(VectorXd(arm.q()) == q);
  };
  RobotSpec massless = random_heavy_arm(*std::make_unique<Random>(1), 3).spec();
  massless.links[2] = Link{};
  expect(massless, VectorXd::Zero(3), VectorXd::Zero(3), {}, SimulationStatus::kMassless, 2);
  RobotSpec stiff = slider(1.0, false);
  stiff.links[0].friction.viscous = 1e4;
  expect(stiff, one(0.0), one(0.0), {}, SimulationStatus::kStiff, 0);
  expect(slider(1.0, false), one(0.0), one(5.0), {.step = 1.0}, SimulationStatus::kStepTooLong, 0);
  const auto robot = shared(slider(1.0, false));
  ArmSimulation arm(robot, one(0.0), one(0.0));
  CHECK_THROWS_AS((void)arm.advance(one(NAN), 0.1), ArgumentError);
  CHECK_THROWS_AS((void)arm.advance(VectorXd::Zero(2), 0.1), ArgumentError);
  CHECK_THROWS_AS((void)arm.advance(one(0.0), -0.1), ArgumentError);
  CHECK_THROWS_AS(ArmSimulation(robot, one(11.0), one(0.0)), ArgumentError);
  CHECK_THROWS_AS(ArmSimulation(robot, one(0.0), one(0.0), {.step = 0.0}), ArgumentError);
  CHECK_THROWS_AS(ArmSimulation(robot, one(0.0), one(0.0), {.restitution = 1.5}), ArgumentError);
}
