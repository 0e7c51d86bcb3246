#include "armlet/math/ode.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"

using namespace armlet;

namespace {

// For any equation; those for a state [q; v] have tests of their own.
constexpr std::array<OdeMethod, 5> kMethods = {OdeMethod::kEuler, OdeMethod::kEulerRichardson,
                                               OdeMethod::kRungeKutta4, OdeMethod::kFehlberg45,
                                               OdeMethod::kDormandPrince45};
constexpr std::array<int, 5> kOrders = {1, 2, 4, 5, 5};

// So loose that methods which choose their steps take one for each call.
constexpr double kAnything = 1e12;

using State = std::span<const double>;
using Rate = std::span<double>;

// y' = -2 t y^2, y(0) = 1: y = 1 / (1 + t^2).
bool bell(double t, State y, Rate rate) {
  rate[0] = -2.0 * t * y[0] * y[0];
  return true;
}

double error_at_one(OdeMethod method, int steps) {
  OdeIntegrator integrator(1, method, kAnything);
  std::array<double, 1> y = {1.0};
  for (int k = 0; k < steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    REQUIRE(integrator.advance(bell, t, 1.0 / steps, y).status == OdeStatus::kDone);
  }
  return std::abs(y[0] - 0.5);
}

// Goes from t0 to t1 in equal frames and returns the last outcome.
OdeOutcome run(OdeIntegrator& integrator, const OdeRate& rate, double t0, double t1, int frames,
               std::span<double> y) {
  OdeOutcome outcome;
  for (int k = 0; k < frames && outcome.status == OdeStatus::kDone; ++k) {
    const double from = t0 + (t1 - t0) * k / frames;
    outcome = integrator.advance(rate, from, (t1 - t0) / frames, y);
  }
  return outcome;
}

}  // namespace

TEST_CASE("methods are found by their names") {
  REQUIRE(ode_method_names().size() == 7);
  for (std::size_t i = 0; i < ode_method_names().size(); ++i)
    CHECK(ode_method(ode_method_names()[i]) == static_cast<OdeMethod>(i));
  CHECK(ode_method("euler-richardson") == OdeMethod::kEulerRichardson);
  CHECK(ode_method("rkf45") == OdeMethod::kFehlberg45);
  CHECK(ode_method("dopri5") == OdeMethod::kDormandPrince45);
  CHECK(ode_method("verlet") == OdeMethod::kVerlet);
  CHECK_FALSE(ode_method("rk5").has_value());
}

TEST_CASE("halving the step divides the error by two to the order of the method") {
  for (std::size_t i = 0; i < kMethods.size(); ++i) {
    CAPTURE(kOrders[i]);
    const double coarse = error_at_one(kMethods[i], 32);
    const double fine = error_at_one(kMethods[i], 64);
    const double order = std::log2(coarse / fine);
    // The next power of h is still visible at these steps.
    CHECK(order == doctest::Approx(kOrders[i]).epsilon(0.05));
  }
}

TEST_CASE("polynomials up to the order of the method are exact in one step") {
  Random random(3);
  for (std::size_t i = 0; i < kMethods.size(); ++i) {
    for (int trial = 0; trial < 100; ++trial) {
      std::array<double, 6> c{};
      for (int k = 0; k <= kOrders[i]; ++k) c[k] = random.uniform(-1.0, 1.0);
      const auto value = [&](double t) {
        double sum = 0.0;
        for (int k = 5; k >= 0; --k) sum = sum * t + c[k];
        return sum;
      };
      const OdeRate rate = [&](double t, State, Rate out) {
        out[0] = 0.0;
        for (int k = 5; k > 0; --k) out[0] = out[0] * t + k * c[k];
        return true;
      };
      OdeIntegrator integrator(1, kMethods[i], kAnything);
      std::array<double, 1> y = {value(-0.5)};
      REQUIRE(integrator.advance(rate, -0.5, 1.5, y).status == OdeStatus::kDone);
      CHECK(std::abs(y[0] - value(1.0)) < 1e-13);  // some roundings of numbers below 10
    }
  }
}

// Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed. 1993, section II.0:
// an orbit about earth and moon that closes.
TEST_CASE("the orbit of Arenstorf closes") {
  constexpr double kMoon = 0.012277471;
  constexpr double kPeriod = 17.0652165601579625588917206249;
  const std::array<double, 4> start = {0.994, 0.0, 0.0, -2.00158510637908252240537862224};
  const OdeRate rate = [](double, State y, Rate out) {
    const double earth = std::pow((y[0] + kMoon) * (y[0] + kMoon) + y[1] * y[1], 1.5);
    const double rest = 1.0 - kMoon;
    const double moon = std::pow((y[0] - rest) * (y[0] - rest) + y[1] * y[1], 1.5);
    out[0] = y[2];
    out[1] = y[3];
    out[2] = y[0] + 2.0 * y[3] - rest * (y[0] + kMoon) / earth - kMoon * (y[0] - rest) / moon;
    out[3] = y[1] - 2.0 * y[2] - rest * y[1] / earth - kMoon * y[1] / moon;
    return true;
  };
  OdeIntegrator integrator(4, OdeMethod::kFehlberg45, 1e-13);
  std::array<double, 4> y = start;
  REQUIRE(run(integrator, rate, 0.0, kPeriod, 50, y).status == OdeStatus::kDone);
  // The orbit passes the moon closely and multiplies errors by about a million.
  CHECK(std::hypot(y[0] - start[0], y[1] - start[1]) < 1e-5);
}

// The arithmetic-geometric mean gives the period of a pendulum of any amplitude (C. F. Gauss; see
// S. Adlaj, Notices of the AMS 59(8), 2012).
TEST_CASE("a pendulum passes its lowest point after a quarter of the exact period") {
  for (const double amplitude : {0.1, 1.0, 2.0, 3.0}) {
    double a = 1.0;
    double g = std::cos(amplitude / 2.0);
    for (int k = 0; k < 8; ++k) {
      const double mean = 0.5 * (a + g);
      g = std::sqrt(a * g);
      a = mean;
    }
    const double period = 2.0 * std::numbers::pi / std::sqrt(9.81) / a;
    const OdeRate rate = [](double, State y, Rate out) {
      out[0] = y[1];
      out[1] = -9.81 * std::sin(y[0]);
      return true;
    };
    OdeIntegrator integrator(2, OdeMethod::kFehlberg45, 1e-12);
    std::array<double, 2> y = {amplitude, 0.0};
    REQUIRE(run(integrator, rate, 0.0, period / 4.0, 7, y).status == OdeStatus::kDone);
    CHECK(std::abs(y[0]) < 1e-9);
  }
}

TEST_CASE("a smaller tolerance gives a smaller error, and frames do not add to it") {
  const OdeRate rate = [](double, State y, Rate out) {
    out[0] = y[1];
    out[1] = -y[0];
    return true;
  };
  for (const double tolerance : {1e-5, 1e-8, 1e-11}) {
    for (const int frames : {1, 10, 1000}) {
      OdeIntegrator integrator(2, OdeMethod::kFehlberg45, tolerance);
      std::array<double, 2> y = {1.0, 0.0};
      REQUIRE(run(integrator, rate, 0.0, 20.0, frames, y).status == OdeStatus::kDone);
      // Errors of steps add up over 20 units of time.
      CHECK(std::hypot(y[0] - std::cos(20.0), y[1] + std::sin(20.0)) < 40.0 * tolerance);
    }
  }
}

TEST_CASE("a frame that cuts a step short does not shorten the steps behind it") {
  const OdeRate rate = [](double, State y, Rate out) {
    out[0] = -y[0];
    return true;
  };
  OdeIntegrator integrator(1, OdeMethod::kFehlberg45, 1e-6);
  std::array<double, 1> y = {1.0};
  REQUIRE(integrator.advance(rate, 0.0, 1.0, y).status == OdeStatus::kDone);
  REQUIRE(integrator.advance(rate, 1.0, 1e-9, y).status == OdeStatus::kDone);
  const std::int64_t before = integrator.evaluations();
  REQUIRE(integrator.advance(rate, 1.0 + 1e-9, 0.1, y).status == OdeStatus::kDone);
  CHECK(integrator.evaluations() - before == 6);
}

TEST_CASE("going back in time leads to the start") {
  for (const OdeMethod method : kMethods) {
    OdeIntegrator integrator(1, method, 1e-10);
    std::array<double, 1> y = {1.0};
    REQUIRE(run(integrator, bell, 0.0, 1.0, 1000, y).status == OdeStatus::kDone);
    REQUIRE(run(integrator, bell, 1.0, 0.0, 1000, y).status == OdeStatus::kDone);
    CHECK(std::abs(y[0] - 1.0) < 2e-3);  // Euler's; the others are far better
  }
}

TEST_CASE("a solution that runs to infinity is reported near the point") {
  const OdeRate rate = [](double, State y, Rate out) {  // 1 / (1 - t)
    out[0] = y[0] * y[0];
    return true;
  };
  OdeIntegrator integrator(1, OdeMethod::kFehlberg45);
  std::array<double, 1> y = {1.0};
  const OdeOutcome outcome = integrator.advance(rate, 0.0, 2.0, y);
  CHECK(outcome.status == OdeStatus::kStepTooSmall);
  CHECK(outcome.t == doctest::Approx(1.0).epsilon(1e-6));
}

TEST_CASE("a rate that is not finite is reported with the element at fault") {
  const OdeRate rate = [](double t, State, Rate out) {
    out[0] = 1.0;
    out[1] = t < 0.55 ? 1.0 : std::numeric_limits<double>::quiet_NaN();
    return true;
  };
  for (const OdeMethod method : {OdeMethod::kEuler, OdeMethod::kRungeKutta4}) {
    OdeIntegrator integrator(2, method);
    std::array<double, 2> y = {0.0, 0.0};
    const OdeOutcome outcome = run(integrator, rate, 0.0, 1.0, 10, y);
    CHECK(outcome.status == OdeStatus::kNotFinite);
    CHECK(outcome.element == 1);
    CHECK(outcome.t == doctest::Approx(0.7).epsilon(0.1));
  }
  OdeIntegrator adaptive(2, OdeMethod::kFehlberg45);
  std::array<double, 2> y = {0.0, 0.0};
  const OdeOutcome outcome = run(adaptive, rate, 0.0, 1.0, 10, y);
  CHECK(outcome.status != OdeStatus::kDone);
  CHECK(outcome.t == doctest::Approx(0.55).epsilon(1e-9));
}

TEST_CASE("the rate function can stop the integration") {
  for (const OdeMethod method : kMethods) {
    const OdeRate rate = [](double t, State, Rate out) {
      out[0] = 1.0;
      return t < 0.5;
    };
    OdeIntegrator integrator(1, method);
    std::array<double, 1> y = {0.0};
    CHECK(run(integrator, rate, 0.0, 1.0, 10, y).status == OdeStatus::kStopped);
  }
}

TEST_CASE("a system without elements goes through, and wrong arguments are refused") {
  OdeIntegrator nothing(0, OdeMethod::kFehlberg45);
  CHECK(nothing.advance([](double, State, Rate) { return true; }, 0.0, 1.0, {}).status ==
        OdeStatus::kDone);
  CHECK_THROWS_AS(OdeIntegrator(-1, OdeMethod::kEuler), ArgumentError);
  CHECK_THROWS_AS(OdeIntegrator(1, OdeMethod::kFehlberg45, 0.0), ArgumentError);
  OdeIntegrator one(1, OdeMethod::kEuler);
  std::array<double, 2> y = {0.0, 0.0};
  CHECK_THROWS_AS(one.advance(bell, 0.0, 1.0, y), ArgumentError);
  CHECK_THROWS_AS(one.advance(bell, INFINITY, 1.0, std::span(y).first(1)), ArgumentError);
}
