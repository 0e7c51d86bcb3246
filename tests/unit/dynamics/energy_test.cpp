#include "armlet/dynamics/energy.hpp"

#include <doctest/doctest.h>

#include "armlet/dynamics/forward_dynamics.hpp"
#include "armlet/math/ode.hpp"
#include "random_mass.hpp"

using namespace armlet;
using Eigen::VectorXd;

namespace {

double energy_of(const Robot& robot, const VectorXd& y) {
  const int n = robot.n();
  return kinetic_energy(robot, y.head(n), y.tail(n)) + potential_energy(robot, y.head(n));
}

// The largest change of the energy of an arm that falls freely for 0.2 s.
double drift(const Robot& robot, VectorXd y, double step) {
  const int n = robot.n();
  OdeIntegrator integrator(2 * n, OdeMethod::kRungeKutta4);
  const VectorXd zero = VectorXd::Zero(n);
  const OdeRate fall = [&](double, std::span<const double> state, std::span<double> rate) {
    const Eigen::Map<const VectorXd> x(state.data(), 2 * n);
    Eigen::Map<VectorXd> out(rate.data(), 2 * n);
    out << x.tail(n), forward_dynamics(robot, x.head(n), x.tail(n), zero);
    return true;
  };
  const double before = energy_of(robot, y);
  double most = 0.0;
  for (double t = 0.0; t < 0.2; t += step) {
    (void)integrator.advance(fall, t, step, {y.data(), static_cast<std::size_t>(2 * n)});
    most = std::max(most, std::abs(energy_of(robot, y) - before));
  }
  return most;
}

}  // namespace

// What is left of a method of order 4 falls to a sixteenth when the step is halved, or is rounding.
TEST_CASE("the energy of a falling arm without friction is constant") {
  Random random(21);
  for (int n = 1; n <= 7; ++n) {
    CAPTURE(n);
    const Robot robot = random_heavy_arm(random, n);
    VectorXd y(2 * n);
    y << random_values(random, n), random_rates(random, n);
    const double scale = 1.0 + std::abs(energy_of(robot, y));
    const double coarse = drift(robot, y, 1e-3), fine = drift(robot, y, 5e-4);
    CHECK(fine < 1e-5 * scale);
    CHECK(fine < coarse / 8.0 + 1e-11 * scale);
  }
}
