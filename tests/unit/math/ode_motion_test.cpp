// Methods for a state [q; v], and the polynomial of Dormand and Prince.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/math/ode.hpp"

using namespace armlet;

namespace {

using State = std::span<const double>;
using Rate = std::span<double>;

// q'' = -q - drag v.
OdeRate spring(double drag) {
  return [drag](double, State y, Rate rate) {
    rate[0] = y[1];
    rate[1] = -y[0] - drag * y[1];
    return true;
  };
}

// q(t) for q(0) = 1, v(0) = 0.
double spring_at(double drag, double t) {
  const double w = std::sqrt(1.0 - 0.25 * drag * drag);
  return std::exp(-0.5 * drag * t) * (std::cos(w * t) + 0.5 * drag / w * std::sin(w * t));
}

double error_at_two(OdeMethod method, double drag, int steps) {
  OdeIntegrator integrator(2, method);
  std::array<double, 2> y = {1.0, 0.0};
  for (int k = 0; k < steps; ++k)
    REQUIRE(integrator.advance(spring(drag), 2.0 * k / steps, 2.0 / steps, y).status ==
            OdeStatus::kDone);
  return std::abs(y[0] - spring_at(drag, 2.0));
}

}  // namespace

TEST_CASE("halving the step of a method for [q; v] shows its order, with drag and without") {
  for (const double drag : {0.0, 0.3}) {
    const auto order = [&](OdeMethod method) {
      return std::log2(error_at_two(method, drag, 400) / error_at_two(method, drag, 800));
    };
    CHECK(order(OdeMethod::kSymplectic) == doctest::Approx(1.0).epsilon(0.05));
    CHECK(order(OdeMethod::kVerlet) == doctest::Approx(2.0).epsilon(0.05));
  }
}

TEST_CASE("the energy of a spring stays within a bound, however long it swings; Euler's grows") {
  const auto energy = [](State y) { return 0.5 * (y[0] * y[0] + y[1] * y[1]); };
  const auto most = [&](OdeMethod method, int periods) {
    OdeIntegrator integrator(2, method);
    std::array<double, 2> y = {1.0, 0.0};
    double worst = 0.0;
    const double h = 2.0 * std::numbers::pi / 100;
    for (int k = 0; k < 100 * periods; ++k) {
      (void)integrator.advance(spring(0.0), k * h, h, y);
      worst = std::max(worst, std::abs(energy(y) - 0.5));
    }
    return worst;
  };
  CHECK(most(OdeMethod::kSymplectic, 1000) < 1.01 * most(OdeMethod::kSymplectic, 10));
  CHECK(most(OdeMethod::kVerlet, 1000) < 1.01 * most(OdeMethod::kVerlet, 10));
  CHECK(most(OdeMethod::kEuler, 20) > 10.0);
}

TEST_CASE("a rate of q that is not v is refused with its element, an odd state with its size") {
  const OdeRate wrong = [](double, State y, Rate rate) {
    rate[0] = y[2];
    rate[1] = 2.0 * y[3];
    rate[2] = rate[3] = 0.0;
    return true;
  };
  for (const OdeMethod method : {OdeMethod::kSymplectic, OdeMethod::kVerlet}) {
    OdeIntegrator integrator(4, method);
    std::array<double, 4> y = {0.0, 0.0, 1.0, 1.0};
    const OdeOutcome outcome = integrator.advance(wrong, 0.0, 0.1, y);
    CHECK(outcome.status == OdeStatus::kNotRates);
    CHECK(outcome.element == 1);
    CHECK(y == std::array<double, 4>{0.0, 0.0, 1.0, 1.0});
    CHECK_THROWS_AS(OdeIntegrator(3, method), ArgumentError);
  }
}

TEST_CASE("between its steps dopri5 is as exact as at them, and frames cost no evaluations") {
  std::int64_t evaluations[2] = {};
  const int frames[2] = {10, 10'000};
  for (int k = 0; k < 2; ++k) {
    OdeIntegrator integrator(2, OdeMethod::kDormandPrince45, 1e-10);
    std::array<double, 2> y = {1.0, 0.0};
    double worst = 0.0;
    for (int i = 0; i < frames[k]; ++i) {
      const double t = 20.0 * i / frames[k], next = 20.0 * (i + 1) / frames[k];
      REQUIRE(integrator.advance(spring(0.1), t, next - t, y, 20.0 + 1e-9).status ==
              OdeStatus::kDone);
      worst = std::max(worst, std::abs(y[0] - spring_at(0.1, next)));
    }
    CHECK(worst < 1e-8);
    evaluations[k] = integrator.evaluations();
  }
  CHECK(evaluations[1] < evaluations[0] + evaluations[0] / 5);
}

// So loose a tolerance takes the longest step that it may: first h, then to the horizon.
TEST_CASE(
    "the polynomial of a step has order 4 in its middle, and f is not asked past the horizon") {
  const auto error = [](double h) {
    OdeIntegrator integrator(2, OdeMethod::kDormandPrince45, 1e12);
    std::array<double, 2> y = {1.0, 0.0};
    double latest = 0.0;
    const OdeRate rate = [&](double t, State x, Rate out) {
      latest = std::max(latest, t);
      return spring(0.0)(t, x, out);
    };
    REQUIRE(integrator.advance(rate, 0.0, h, y).status == OdeStatus::kDone);
    REQUIRE(integrator.advance(rate, h, 0.5 * h, y, 2.0 * h).status == OdeStatus::kDone);
    CHECK(latest == 2.0 * h);
    return std::hypot(y[0] - std::cos(1.5 * h), y[1] + std::sin(1.5 * h));
  };
  CHECK(std::log2(error(0.2) / error(0.1)) == doctest::Approx(5.0).epsilon(0.06));  // of one step
}

TEST_CASE("a state that somebody else changed starts anew") {
  OdeIntegrator integrator(2, OdeMethod::kDormandPrince45, 1e-10);
  std::array<double, 2> y = {1.0, 0.0};
  (void)integrator.advance(spring(0.0), 0.0, 0.1, y, 10.0);
  y = {2.0, 0.0};
  REQUIRE(integrator.advance(spring(0.0), 0.1, 1.0, y, 10.0).status == OdeStatus::kDone);
  CHECK(y[0] == doctest::Approx(2.0 * std::cos(1.0)).epsilon(1e-8));
  CHECK_THROWS_AS(integrator.advance(spring(0.0), 1.1, 1.0, y, 1.5), ArgumentError);
}
