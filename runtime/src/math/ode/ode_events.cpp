#include "armlet/math/ode_events.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "armlet/core/error.hpp"

namespace armlet {
namespace {

constexpr double kInstant = 1e-11;  // s
constexpr int kMostSteps = 200;

bool crosses(double before, double after, CrossingDirection direction) {
  const bool rises = before < 0.0 && after >= 0.0;
  const bool falls = before > 0.0 && after <= 0.0;
  return (rises && direction != CrossingDirection::kFalling) ||
         (falls && direction != CrossingDirection::kRising);
}

}  // namespace

OdeEvents::OdeEvents(std::vector<OdeWitness> witnesses, int size, OdeMethod method,
                     double tolerance)
    : witnesses_(std::move(witnesses)),
      integrator_(size, method, tolerance),
      before_(witnesses_.size()),
      after_(witnesses_.size()),
      trial_(static_cast<std::size_t>(size)) {}

OdeEvents::Outcome OdeEvents::values_at(double t, std::span<const double> y,
                                        std::vector<double>& values) {
  for (std::size_t k = 0; k < witnesses_.size(); ++k) {
    const int witness = static_cast<int>(k);
    if (!witnesses_[k].g(t, y, values[k])) return {Status::kStopped, t, witness};
    if (!std::isfinite(values[k])) return {Status::kNotFinite, t, witness};
  }
  return {};
}

OdeEvents::Outcome OdeEvents::begin(double t, std::span<const double> y) {
  check_size("y", static_cast<std::ptrdiff_t>(y.size()),
             static_cast<std::ptrdiff_t>(trial_.size()));
  return values_at(t, y, before_);
}

OdeEvents::Outcome OdeEvents::look(const OdeRate& rate, double t, double h,
                                   std::span<const double> y, std::span<const double> next) {
  found_.clear();
  if (const Outcome outcome = values_at(t + h, next, after_); outcome.status != Status::kDone)
    return outcome;
  for (std::size_t k = 0; k < witnesses_.size(); ++k) {
    if (!crosses(before_[k], after_[k], witnesses_[k].direction)) continue;
    const Outcome outcome = locate(rate, t, h, y, next, static_cast<int>(k));
    if (outcome.status != Status::kDone) return outcome;
  }
  std::ranges::stable_sort(found_, {}, &OdeCrossing::t);
  before_.swap(after_);
  return {};
}

// The Illinois method, with bisection where it converges too slowly.
OdeEvents::Outcome OdeEvents::locate(const OdeRate& rate, double t, double h,
                                     std::span<const double> y, std::span<const double> next,
                                     int witness) {
  const auto at = static_cast<std::size_t>(witness);
  const double enough =
      std::max(kInstant, 4.0 * std::numeric_limits<double>::epsilon() * std::abs(t + h));
  double low = 0.0, high = h, at_low = before_[at], at_high = after_[at];
  std::vector<double> behind(next.begin(), next.end());
  int side = 0;
  for (int k = 0; k < kMostSteps && high - low > enough && at_high != 0.0; ++k) {
    double middle = (low * at_high - high * at_low) / (at_high - at_low);
    // Every third step is a bisection, whatever the values are.
    if (k % 3 == 2 || !(middle > low && middle < high)) middle = 0.5 * (low + high);
    middle = std::clamp(middle, low + 0.25 * enough, high - 0.25 * enough);
    std::ranges::copy(y, trial_.begin());
    integrator_.restart();
    const OdeOutcome outcome = integrator_.advance(rate, t, middle, trial_);
    if (outcome.status == OdeStatus::kStopped) return {Status::kStopped, outcome.t, witness};
    if (outcome.status != OdeStatus::kDone) return {Status::kNoStep, outcome.t, witness};
    double value = 0.0;
    if (!witnesses_[at].g(t + middle, trial_, value)) return {Status::kStopped, t, witness};
    if (!std::isfinite(value)) return {Status::kNotFinite, t + middle, witness};
    if (value == 0.0 || std::signbit(value) != std::signbit(before_[at])) {
      high = middle;
      at_high = value;
      behind.assign(trial_.begin(), trial_.end());
      if (side == 1) at_low *= 0.5;
      side = 1;
    } else {
      low = middle;
      at_low = value;
      if (side == -1) at_high *= 0.5;
      side = -1;
    }
  }
  found_.push_back({.t = t + high, .witness = witness, .y = std::move(behind)});
  return {};
}

}  // namespace armlet
