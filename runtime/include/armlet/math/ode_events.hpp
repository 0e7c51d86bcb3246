#pragma once
// Event location: the instants at which a function of time and state becomes zero during an
// integration.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "armlet/math/ode.hpp"

namespace armlet {

enum class CrossingDirection : std::uint8_t { kBoth, kRising, kFalling };

// g  writes g(t, y) to `value`; returns false to end the integration.
struct OdeWitness {
  std::function<bool(double t, std::span<const double> y, double& value)> g{};
  CrossingDirection direction = CrossingDirection::kBoth;
};

// A zero of a witness, at t; y is the state just after it.
struct OdeCrossing {
  double t = 0.0;
  int witness = 0;
  std::vector<double> y{};
};

// Checks the steps of an integration one after another. Two zeros of one witness within one step
// are not found.
class OdeEvents {
 public:
  // size, method, tolerance  as of the integrator whose steps are checked.
  OdeEvents(std::vector<OdeWitness> witnesses, int size, OdeMethod method, double tolerance = 1e-8);

  enum class Status : std::uint8_t {
    kDone,
    kStopped,    // a function returned false
    kNotFinite,  // a witness is infinite or undefined
    kNoStep,     // the equation could not be integrated up to the zero
  };
  struct Outcome {
    Status status = Status::kDone;
    double t = 0.0;
    int witness = 0;
  };

  // Sets the initial state. A witness that is zero there has no event there.
  Outcome begin(double t, std::span<const double> y);

  // After a step from y at t to `next` at t + h: the zeros in it, in the order of time, then of the
  // witnesses. Zeros are located to 1e-11 s, or to rounding of t, by shorter steps from y.
  Outcome look(const OdeRate& rate, double t, double h, std::span<const double> y,
               std::span<const double> next);
  [[nodiscard]] const std::vector<OdeCrossing>& found() const { return found_; }

 private:
  Outcome values_at(double t, std::span<const double> y, std::vector<double>& values);
  Outcome locate(const OdeRate& rate, double t, double h, std::span<const double> y,
                 std::span<const double> next, int witness);

  std::vector<OdeWitness> witnesses_;
  OdeIntegrator integrator_;
  std::vector<double> before_, after_;  // values of the witnesses
  std::vector<double> trial_;
  std::vector<OdeCrossing> found_;
};

}  // namespace armlet
