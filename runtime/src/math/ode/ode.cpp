#include "armlet/math/ode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"
#include "ode_vectors.hpp"

namespace armlet {
namespace {

constexpr std::array<std::string_view, 7> kNames = {
    "euler", "symplectic", "euler-richardson", "rk4", "rkf45", "dopri5", "verlet"};

bool splits_state(OdeMethod method) {
  return method == OdeMethod::kSymplectic || method == OdeMethod::kVerlet;
}

}  // namespace

std::span<const std::string_view> ode_method_names() { return kNames; }

std::optional<OdeMethod> ode_method(std::string_view name) {
  const auto found = std::ranges::find(kNames, name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<OdeMethod>(found - kNames.begin());
}

OdeIntegrator::OdeIntegrator(int size, OdeMethod method, double tolerance)
    : size_(size), method_(method), tolerance_(tolerance) {
  if (size < 0)
    throw ArgumentError(fmt::format("A state cannot have {} elements; expected 0 or more.", size));
  if (splits_state(method) && size % 2 != 0) {
    throw ArgumentError(fmt::format(
        "A state [q; v] cannot have {} elements; expected as many rates as values.", size));
  }
  check_positive("tolerance", tolerance);
  work_.resize(static_cast<std::size_t>(size) * kOdeVectors);
}

OdeOutcome OdeIntegrator::advance(const OdeRate& rate, double t, double h, std::span<double> y,
                                  std::optional<double> horizon) {
  check_size("y", static_cast<Eigen::Index>(y.size()), size_);
  check_finite("t", t);
  check_finite("h", h);
  if (horizon) {
    check_finite("horizon", *horizon);
    if ((*horizon - (t + h)) * (h < 0.0 ? -1.0 : 1.0) < 0.0)
      throw ArgumentError("The horizon lies before the end of the step; expected it not to.");
  }
  bool goes_on = false;
  switch (method_) {
    case OdeMethod::kFehlberg45:
      knows_first_ = false;
      return pair_to(rate, t, t + h, y);
    case OdeMethod::kDormandPrince45:
      return dense_to(rate, t, t + h, horizon.value_or(t + h), y);
    case OdeMethod::kSymplectic:
    case OdeMethod::kVerlet:
      return second_order(rate, t, h, y);
    case OdeMethod::kEuler:
      goes_on = euler(rate, t, h, y);
      break;
    case OdeMethod::kEulerRichardson:
      goes_on = euler_richardson(rate, t, h, y);
      break;
    case OdeMethod::kRungeKutta4:
      goes_on = runge_kutta_4(rate, t, h, y);
      break;
  }
  if (!goes_on) return {OdeStatus::kStopped, t, 0};
  if (const int bad = first_not_finite(y); bad >= 0) return {OdeStatus::kNotFinite, t + h, bad};
  return {OdeStatus::kDone, t + h, 0};
}

bool OdeIntegrator::slope(const OdeRate& rate, double t, std::span<const double> y, int k) {
  ++evaluations_;
  return rate(t, y, stage(k));
}

bool OdeIntegrator::euler(const OdeRate& rate, double t, double h, std::span<double> y) {
  if (!slope(rate, t, y, 0)) return false;
  const auto k = stage(0);
  for (int i = 0; i < size_; ++i) y[i] += h * k[i];
  return true;
}

bool OdeIntegrator::euler_richardson(const OdeRate& rate, double t, double h, std::span<double> y) {
  if (!slope(rate, t, y, 0)) return false;
  const auto k = stage(0);
  const auto middle = stage(kTrial);
  for (int i = 0; i < size_; ++i) middle[i] = y[i] + 0.5 * h * k[i];
  if (!slope(rate, t + 0.5 * h, middle, 0)) return false;
  for (int i = 0; i < size_; ++i) y[i] += h * k[i];
  return true;
}

bool OdeIntegrator::runge_kutta_4(const OdeRate& rate, double t, double h, std::span<double> y) {
  constexpr double kPart[4] = {0.0, 0.5, 0.5, 1.0};
  const auto trial = stage(kTrial);
  if (!slope(rate, t, y, 0)) return false;
  for (int s = 1; s < 4; ++s) {
    const auto before = stage(s - 1);
    for (int i = 0; i < size_; ++i) trial[i] = y[i] + kPart[s] * h * before[i];
    if (!slope(rate, t + kPart[s] * h, trial, s)) return false;
  }
  const auto k1 = stage(0), k2 = stage(1), k3 = stage(2), k4 = stage(3);
  for (int i = 0; i < size_; ++i) y[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
  return true;
}

OdeOutcome OdeIntegrator::second_order(const OdeRate& rate, double t, double h,
                                       std::span<double> y) {
  const int half = size_ / 2;
  const auto before = stage(0), after = stage(1), trial = stage(kTrial);
  if (!slope(rate, t, y, 0)) return {OdeStatus::kStopped, t, 0};
  for (int i = 0; i < half; ++i) {
    if (before[i] != y[half + i]) return {OdeStatus::kNotRates, t, i};
  }
  const auto q = y.first(half), v = y.last(half);
  if (method_ == OdeMethod::kSymplectic) {
    for (int i = 0; i < half; ++i) v[i] += h * before[half + i];
    for (int i = 0; i < half; ++i) q[i] += h * v[i];
  } else {
    for (int i = 0; i < half; ++i) trial[i] = q[i] + h * (v[i] + 0.5 * h * before[half + i]);
    for (int i = half; i < size_; ++i) trial[i] = y[i] + h * before[i];
    if (!slope(rate, t + h, trial, 1)) return {OdeStatus::kStopped, t, 0};
    for (int i = 0; i < half; ++i) q[i] = trial[i];
    for (int i = half; i < size_; ++i) y[i] += 0.5 * h * (before[i] + after[i]);
  }
  if (const int bad = first_not_finite(y); bad >= 0) return {OdeStatus::kNotFinite, t + h, bad};
  return {OdeStatus::kDone, t + h, 0};
}

}  // namespace armlet
