#include "armlet/math/ode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "armlet/core/error.hpp"
#include "armlet/math/det_math.hpp"

namespace armlet {
namespace {

constexpr std::array<std::string_view, 4> kNames = {"euler", "euler-richardson", "rk4", "rkf45"};

constexpr int kTrial = 6;  // the stage that holds a trial state
constexpr int kStages = 7;

constexpr int kMostSteps = 1'000'000;

// Fehlberg 1969, table III, as c, a and the fifth-order weights; kError is their difference from
// the fourth-order ones.
constexpr double kNode[6] = {0.0, 1.0 / 4, 3.0 / 8, 12.0 / 13, 1.0, 1.0 / 2};
constexpr double kSlope[6][5] = {{},
                                 {1.0 / 4},
                                 {3.0 / 32, 9.0 / 32},
                                 {1932.0 / 2197, -7200.0 / 2197, 7296.0 / 2197},
                                 {439.0 / 216, -8.0, 3680.0 / 513, -845.0 / 4104},
                                 {-8.0 / 27, 2.0, -3544.0 / 2565, 1859.0 / 4104, -11.0 / 40}};
constexpr double kWeight[6] = {16.0 / 135,      0.0,       6656.0 / 12825,
                               28561.0 / 56430, -9.0 / 50, 2.0 / 55};
constexpr double kError[6] = {1.0 / 360, 0.0, -128.0 / 4275, -2197.0 / 75240, 1.0 / 50, 2.0 / 55};

// How much longer or shorter the next step should be, from the error in units of the tolerance.
double step_factor(double error) {
  if (!(error > 0.0)) return 5.0;
  return std::clamp(0.9 * det::pow(error, -0.2), 0.2, 5.0);
}

int first_not_finite(std::span<const double> y) {
  const auto bad = std::ranges::find_if(y, [](double x) { return !std::isfinite(x); });
  return bad == y.end() ? -1 : static_cast<int>(bad - y.begin());
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
  check_positive("tolerance", tolerance);
  work_.resize(static_cast<std::size_t>(size) * kStages);
}

OdeOutcome OdeIntegrator::advance(const OdeRate& rate, double t, double h, std::span<double> y) {
  check_size("y", static_cast<Eigen::Index>(y.size()), size_);
  check_finite("t", t);
  check_finite("h", h);
  if (method_ == OdeMethod::kFehlberg45) return fehlberg(rate, t, h, y);
  bool goes_on = false;
  switch (method_) {
    case OdeMethod::kEuler:
      goes_on = euler(rate, t, h, y);
      break;
    case OdeMethod::kEulerRichardson:
      goes_on = euler_richardson(rate, t, h, y);
      break;
    default:
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

// The slopes after the first, and the trial state they lead to.
bool OdeIntegrator::fehlberg_stages(const OdeRate& rate, double t, double h,
                                    std::span<const double> y) {
  const auto trial = stage(kTrial);
  const auto move = [&](const double* weights, int count) {
    for (int i = 0; i < size_; ++i) {
      double sum = 0.0;
      for (int s = 0; s < count; ++s) sum += weights[s] * stage(s)[i];
      trial[i] = y[i] + h * sum;
    }
  };
  for (int s = 1; s < 6; ++s) {
    move(kSlope[s], s);
    if (!slope(rate, t + kNode[s] * h, trial, s)) return false;
  }
  move(kWeight, 6);
  return true;
}

// The estimated error of the trial state in units of the tolerance; infinite if it is of no use.
double OdeIntegrator::fehlberg_error(double h, std::span<const double> y) {
  const auto trial = stage(kTrial);
  if (first_not_finite(trial) >= 0) return std::numeric_limits<double>::infinity();
  double squares = 0.0;
  for (int i = 0; i < size_; ++i) {
    double error = 0.0;
    for (int s = 0; s < 6; ++s) error += kError[s] * stage(s)[i];
    const double scale = tolerance_ * (1.0 + std::max(std::abs(y[i]), std::abs(trial[i])));
    squares += (h * error / scale) * (h * error / scale);
  }
  return size_ == 0 ? 0.0 : std::sqrt(squares / size_);
}

OdeOutcome OdeIntegrator::fehlberg(const OdeRate& rate, double t, double h, std::span<double> y) {
  const double end = t + h;
  // Steps that no longer change the time.
  const double shortest =
      16.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(t), std::abs(end));
  bool knows_first = false;
  for (int step = 0; step < kMostSteps; ++step) {
    const double left = end - t;
    const bool is_last = !(own_step_ > 0.0) || own_step_ >= std::abs(left);
    const double size = is_last ? left : std::copysign(own_step_, left);
    if (!knows_first && !slope(rate, t, y, 0)) return {OdeStatus::kStopped, t, 0};
    knows_first = true;
    if (const int bad = first_not_finite(stage(0)); bad >= 0)
      return {OdeStatus::kNotFinite, t, bad};
    if (!fehlberg_stages(rate, t, size, y)) return {OdeStatus::kStopped, t, 0};
    const double error = fehlberg_error(size, y);
    const double proposed = std::abs(size) * step_factor(error);
    if (error > 1.0) {
      own_step_ = proposed;
      if (own_step_ <= shortest) return {OdeStatus::kStepTooSmall, t, 0};
      continue;
    }
    std::ranges::copy(stage(kTrial), y.begin());
    knows_first = false;
    // A step cut short by the end says nothing against the longer one.
    own_step_ = is_last ? std::max(own_step_, proposed) : proposed;
    t = is_last ? end : t + size;
    if (is_last) return {OdeStatus::kDone, end, 0};
  }
  return {OdeStatus::kTooManySteps, t, 0};
}

}  // namespace armlet
