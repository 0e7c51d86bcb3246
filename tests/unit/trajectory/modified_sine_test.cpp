// The planner ModSine against the published factors of the law and its own acceleration,
// integrated.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "armlet/trajectory/planner.hpp"

using namespace armlet;

namespace {

Trajectory from_0_to_1(double T) {
  MoveRequest request{.q0 = Eigen::VectorXd::Zero(1), .q1 = Eigen::VectorXd::Ones(1)};
  request.limits = {AxisLimits{}};
  request.time = T;
  return *PlannerSet().plan("ModSine", request).trajectory;
}

double acceleration(double x) {
  constexpr double kPi = std::numbers::pi;
  if (x > 0.5) return -acceleration(1.0 - x);
  const double peak = 4.0 * kPi * kPi / (kPi + 4.0);
  return peak * (x < 0.125 ? std::sin(4.0 * kPi * x) : std::cos(4.0 * kPi / 3.0 * (x - 0.125)));
}

}  // namespace

// R. L. Norton, Cam Design and Manufacturing Handbook, 2009, chapter 3: the peak factors of the
// modified sine are 1.760 for velocity, 5.528 for acceleration and 69.47 for jerk.
TEST_CASE("the modified sine has its published peaks") {
  const Trajectory motion = from_0_to_1(1.0);
  CHECK(motion.peak(0, 1) == doctest::Approx(1.760).epsilon(3e-4));
  CHECK(motion.peak(0, 2) == doctest::Approx(5.528).epsilon(1e-4));
  CHECK(motion.peak(0, 3) == doctest::Approx(69.47).epsilon(1e-3));
  CHECK(motion.continuity(0, 1e-8) == 2);
}

// Simpson's rule over pieces that end where the acceleration changes its formula.
TEST_CASE("the modified sine is its acceleration integrated twice") {
  const double T = 2.5;
  const Trajectory motion = from_0_to_1(T);
  constexpr int kSteps = 8000;
  const double h = 1.0 / kSteps;
  double s = 0.0, v = 0.0;
  for (int k = 0; k < kSteps; ++k) {
    const double x = k * h;
    CHECK(std::abs(motion.value(0, x * T, 0) - s) < 1e-10);
    CHECK(std::abs(motion.value(0, x * T, 1) * T - v) < 1e-8);
    const double a0 = acceleration(x), a1 = acceleration(x + 0.5 * h), a2 = acceleration(x + h);
    s += h * v + h * h * (a0 + 2.0 * a1) / 6.0;
    v += h * (a0 + 4.0 * a1 + a2) / 6.0;
  }
  CHECK(std::abs(s - 1.0) < 1e-10);
}
