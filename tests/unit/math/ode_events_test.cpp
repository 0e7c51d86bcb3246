#include "armlet/math/ode_events.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "armlet/core/random.hpp"

using namespace armlet;

namespace {

using State = std::span<const double>;

// y'' = -y.
bool swing(double, State y, std::span<double> rate) {
  rate[0] = y[1];
  rate[1] = -y[0];
  return true;
}

OdeWitness level(double height, CrossingDirection direction) {
  return {.g =
              [height](double, State y, double& value) {
                value = y[0] - height;
                return true;
              },
          .direction = direction};
}

constexpr OdeMethod kAll[] = {OdeMethod::kEuler,           OdeMethod::kSymplectic,
                              OdeMethod::kEulerRichardson, OdeMethod::kRungeKutta4,
                              OdeMethod::kFehlberg45,      OdeMethod::kDormandPrince45,
                              OdeMethod::kVerlet};

}  // namespace

// cos t = c at acos c and 2 pi - acos c, falling and rising.
TEST_CASE("zeros are found to 1e-9 s of where they are, in both directions") {
  Random random(51);
  for (int k = 0; k < 50; ++k) {
    const double c = random.uniform(-0.95, 0.95);
    const double falls = std::acos(c), rises = 2.0 * std::numbers::pi - falls;
    for (const OdeMethod method : {OdeMethod::kFehlberg45, OdeMethod::kDormandPrince45}) {
      OdeIntegrator integrator(2, method, 1e-13);
      OdeEvents events({level(c, CrossingDirection::kBoth), level(c, CrossingDirection::kRising),
                        level(c, CrossingDirection::kFalling)},
                       2, method, 1e-13);
      std::vector<double> y = {1.0, 0.0}, before;
      REQUIRE(events.begin(0.0, y).status == OdeEvents::Status::kDone);
      std::vector<OdeCrossing> found;
      for (int step = 0; step < 63; ++step) {
        const double t = 0.1 * step;
        before = y;
        REQUIRE(integrator.advance(swing, t, 0.1, y).status == OdeStatus::kDone);
        REQUIRE(events.look(swing, t, 0.1, before, y).status == OdeEvents::Status::kDone);
        found.insert(found.end(), events.found().begin(), events.found().end());
      }
      REQUIRE(found.size() == 4);
      for (const OdeCrossing& crossing : found) {
        const bool first = crossing.t < std::numbers::pi;
        CHECK(std::abs(crossing.t - (first ? falls : rises)) < 1e-9);
        CHECK(std::abs(crossing.y[0] - c) < 1e-9);
        CHECK(crossing.witness != (first ? 1 : 2));
      }
    }
  }
}

// A fixed method has its own solution: the zero of that is found, whatever its error.
TEST_CASE("the zero of what a method makes of the equation is found by every method") {
  for (const OdeMethod method : kAll) {
    CAPTURE(static_cast<int>(method));
    OdeIntegrator integrator(2, method);
    OdeEvents events({level(0.3, CrossingDirection::kBoth)}, 2, method);
    std::vector<double> y = {1.0, 0.0}, before = y;
    REQUIRE(events.begin(0.0, y).status == OdeEvents::Status::kDone);
    double t = 0.0;
    for (; events.found().empty(); t += 0.05) {
      before = y;
      REQUIRE(integrator.advance(swing, t, 0.05, y).status == OdeStatus::kDone);
      REQUIRE(events.look(swing, t, 0.05, before, y).status == OdeEvents::Status::kDone);
      REQUIRE(t < 3.0);
    }
    const OdeCrossing& found = events.found()[0];
    std::vector<double> again = before;
    OdeIntegrator fresh(2, method);
    REQUIRE(fresh.advance(swing, t - 0.05, found.t - (t - 0.05), again).status == OdeStatus::kDone);
    // Methods that choose their steps may choose others.
    const bool chooses = method == OdeMethod::kFehlberg45 || method == OdeMethod::kDormandPrince45;
    CHECK(std::abs(again[0] - 0.3) < (chooses ? 1e-7 : 1e-10));
    CHECK(std::abs(found.y[0] - 0.3) < 1e-10);
    CHECK(found.y[0] <= 0.3);  // just behind it
  }
}

TEST_CASE("a zero at the start is none that is gone through, and one at a step's end is one") {
  OdeIntegrator integrator(2, OdeMethod::kRungeKutta4);
  // y' = 1, 0: the state is the time less 0.5.
  const OdeRate rate = [](double, State, std::span<double> out) {
    out[0] = 1.0;
    out[1] = 0.0;
    return true;
  };
  OdeEvents events({level(0.0, CrossingDirection::kBoth), level(0.5, CrossingDirection::kBoth)}, 2,
                   OdeMethod::kRungeKutta4);
  std::vector<double> y = {0.0, 0.0}, before;
  REQUIRE(events.begin(0.0, y).status == OdeEvents::Status::kDone);
  int count = 0;
  for (int step = 0; step < 4; ++step) {
    before = y;
    REQUIRE(integrator.advance(rate, 0.25 * step, 0.25, y).status == OdeStatus::kDone);
    REQUIRE(events.look(rate, 0.25 * step, 0.25, before, y).status == OdeEvents::Status::kDone);
    for (const OdeCrossing& crossing : events.found()) {
      ++count;
      CHECK(crossing.witness == 1);
      CHECK(crossing.t == 0.5);
    }
  }
  CHECK(count == 1);
}

TEST_CASE("a witness that is no number, or that ends it, is reported") {
  OdeEvents events({{.g =
                         [](double t, State, double& value) {
                           value = 1.0 / (t - 0.5);
                           return t < 0.8;
                         }}},
                   2, OdeMethod::kRungeKutta4);
  std::vector<double> y = {1.0, 0.0};
  REQUIRE(events.begin(0.0, y).status == OdeEvents::Status::kDone);
  CHECK(events.look(swing, 0.0, 0.5, y, y).status == OdeEvents::Status::kNotFinite);
  CHECK(events.look(swing, 0.0, 0.9, y, y).status == OdeEvents::Status::kStopped);
}
