// Embedded pairs of Runge-Kutta methods with step size control, and the interpolation polynomial of
// Dormand and Prince.
#include <limits>

#include "armlet/math/det_math.hpp"
#include "armlet/math/ode.hpp"
#include "ode_vectors.hpp"

namespace armlet {
namespace {

constexpr int kMostSteps = 1'000'000;

// Six slopes determine the result. The pair of Dormand and Prince computes a seventh one there,
// which is the first slope of the next step.
struct Pair {
  double node[6];
  double slope[6][5];
  double weight[6];
  double error[7];  // weights minus those of the result of order 4
  bool takes_seventh;
};

// Fehlberg 1969, table III.
constexpr Pair kFehlberg = {
    .node = {0.0, 1.0 / 4, 3.0 / 8, 12.0 / 13, 1.0, 1.0 / 2},
    .slope = {{},
              {1.0 / 4},
              {3.0 / 32, 9.0 / 32},
              {1932.0 / 2197, -7200.0 / 2197, 7296.0 / 2197},
              {439.0 / 216, -8.0, 3680.0 / 513, -845.0 / 4104},
              {-8.0 / 27, 2.0, -3544.0 / 2565, 1859.0 / 4104, -11.0 / 40}},
    .weight = {16.0 / 135, 0.0, 6656.0 / 12825, 28561.0 / 56430, -9.0 / 50, 2.0 / 55},
    .error = {1.0 / 360, 0.0, -128.0 / 4275, -2197.0 / 75240, 1.0 / 50, 2.0 / 55, 0.0},
    .takes_seventh = false};

// Dormand and Prince 1980, table 2.
constexpr Pair kDormandPrince = {
    .node = {0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0},
    .slope = {{},
              {1.0 / 5},
              {3.0 / 40, 9.0 / 40},
              {44.0 / 45, -56.0 / 15, 32.0 / 9},
              {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
              {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656}},
    .weight = {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
    .error = {71.0 / 57600, 0.0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525,
              -1.0 / 40},
    .takes_seventh = true};

// The coefficients of the fourth power of its interpolation polynomial: Hairer, Norsett, Wanner,
// section II.6.
constexpr double kBend[7] = {-12715105075.0 / 11282082432,  0.0,
                             87487479700.0 / 32700410799,   -10690763975.0 / 1880347072,
                             701980252875.0 / 199316789632, -1453857185.0 / 822651844,
                             69997945.0 / 29380423};

const Pair& pair_of(OdeMethod method) {
  return method == OdeMethod::kFehlberg45 ? kFehlberg : kDormandPrince;
}

// The factor for the next step size, from the error in units of the tolerance.
double step_factor(double error) {
  if (error == 0.0) return 5.0;
  if (!(error > 0.0)) return 0.2;  // NaN
  return std::clamp(0.9 * det::pow(error, -0.2), 0.2, 5.0);
}

}  // namespace

// Computes the slopes after the first, and the trial state.
bool OdeIntegrator::pair_stages(const OdeRate& rate, double t, double h,
                                std::span<const double> y) {
  const Pair& pair = pair_of(method_);
  const auto trial = stage(kTrial);
  const auto move = [&](const double* weights, int count) {
    for (int i = 0; i < size_; ++i) {
      double sum = 0.0;
      for (int s = 0; s < count; ++s) sum += weights[s] * stage(s)[i];
      trial[i] = y[i] + h * sum;
    }
  };
  for (int s = 1; s < 6; ++s) {
    move(pair.slope[s], s);
    if (!slope(rate, t + pair.node[s] * h, trial, s)) return false;
  }
  move(pair.weight, 6);
  return !pair.takes_seventh || slope(rate, t + h, trial, 6);
}

// The estimated error of the trial state in units of the tolerance; infinite if the state is not
// finite.
double OdeIntegrator::pair_error(double h, std::span<const double> y) {
  const Pair& pair = pair_of(method_);
  const auto trial = stage(kTrial);
  const int slopes = pair.takes_seventh ? 7 : 6;
  if (first_not_finite(trial) >= 0) return std::numeric_limits<double>::infinity();
  double squares = 0.0;
  for (int i = 0; i < size_; ++i) {
    double error = 0.0;
    for (int s = 0; s < slopes; ++s) error += pair.error[s] * stage(s)[i];
    const double scale = tolerance_ * (1.0 + std::max(std::abs(y[i]), std::abs(trial[i])));
    squares += (h * error / scale) * (h * error / scale);
  }
  return size_ == 0 ? 0.0 : std::sqrt(squares / size_);
}

// Makes one accepted step from t towards `end`; outcome.t is its end. `steps` counts rejected steps
// too.
OdeOutcome OdeIntegrator::pair_step(const OdeRate& rate, double t, double end, std::span<double> y,
                                    int& steps) {
  // The step is too small to change the time.
  const double shortest =
      16.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(t), std::abs(end));
  for (; steps < kMostSteps; ++steps) {
    const double left = end - t;
    const bool is_last = !(own_step_ > 0.0) || own_step_ >= std::abs(left);
    const double size = is_last ? left : std::copysign(own_step_, left);
    if (!knows_first_ && !slope(rate, t, y, 0)) return {OdeStatus::kStopped, t, 0};
    knows_first_ = true;
    if (const int bad = first_not_finite(stage(0)); bad >= 0)
      return {OdeStatus::kNotFinite, t, bad};
    if (!pair_stages(rate, t, size, y)) return {OdeStatus::kStopped, t, 0};
    const double error = pair_error(size, y);
    const double proposed = std::abs(size) * step_factor(error);
    if (!(error <= 1.0)) {
      own_step_ = proposed;
      if (own_step_ <= shortest) return {OdeStatus::kStepTooSmall, t, 0};
      continue;
    }
    ++steps;
    if (method_ == OdeMethod::kDormandPrince45) make_polynomial(size, y);
    std::ranges::copy(stage(kTrial), y.begin());
    knows_first_ = pair_of(method_).takes_seventh;
    if (knows_first_) std::ranges::copy(stage(6), stage(0).begin());
    // A step that was shortened because of the end does not reduce the step size.
    own_step_ = is_last ? std::max(own_step_, proposed) : proposed;
    return {OdeStatus::kDone, is_last ? end : t + size, 0};
  }
  return {OdeStatus::kTooManySteps, t, 0};
}

OdeOutcome OdeIntegrator::pair_to(const OdeRate& rate, double t, double end, std::span<double> y) {
  OdeOutcome outcome{OdeStatus::kDone, t, 0};
  int steps = 0;
  do {
    outcome = pair_step(rate, outcome.t, end, y, steps);
  } while (outcome.status == OdeStatus::kDone && outcome.t != end);
  return outcome;
}

OdeOutcome OdeIntegrator::dense_to(const OdeRate& rate, double t, double end, double horizon,
                                   std::span<double> y) {
  const double way = end < t ? -1.0 : 1.0;
  const bool goes_on = step_.is_known && t == step_.read && std::ranges::equal(y, stage(kRead)) &&
                       (step_.end - step_.begin) * way > 0.0 && (horizon - step_.end) * way >= 0.0;
  if (!goes_on) {
    std::ranges::copy(y, stage(kAhead).begin());
    step_ = {.begin = t, .end = t, .read = t};
    knows_first_ = false;
  }
  int steps = 0;
  if (!(own_step_ > 0.0)) own_step_ = std::abs(end - t);
  while ((end - step_.end) * way > 0.0) {
    const OdeOutcome outcome = pair_step(rate, step_.end, horizon, stage(kAhead), steps);
    if (outcome.status != OdeStatus::kDone) {
      std::ranges::copy(stage(kAhead), y.begin());
      step_.is_known = false;
      return outcome;
    }
    step_ = {.begin = step_.end, .end = outcome.t, .read = t, .is_known = true};
  }
  read_polynomial(end, y);
  std::ranges::copy(y, stage(kRead).begin());
  step_.read = end;
  return {OdeStatus::kDone, end, 0};
}

void OdeIntegrator::make_polynomial(double h, std::span<const double> before) {
  for (int i = 0; i < size_; ++i) {
    const double change = stage(kTrial)[i] - before[i];
    const double first = h * stage(0)[i] - change;
    double bend = 0.0;
    for (int s = 0; s < 7; ++s) bend += kBend[s] * stage(s)[i];
    stage(kPolynomial)[i] = before[i];
    stage(kPolynomial + 1)[i] = change;
    stage(kPolynomial + 2)[i] = first;
    stage(kPolynomial + 3)[i] = change - h * stage(6)[i] - first;
    stage(kPolynomial + 4)[i] = h * bend;
  }
}

void OdeIntegrator::read_polynomial(double t, std::span<double> y) {
  if (t == step_.end) {
    std::ranges::copy(stage(kAhead), y.begin());
    return;
  }
  const double s = (t - step_.begin) / (step_.end - step_.begin), rest = 1.0 - s;
  const auto c = [&](int k, int i) { return stage(kPolynomial + k)[i]; };
  for (int i = 0; i < size_; ++i)
    y[i] = c(0, i) + s * (c(1, i) + rest * (c(2, i) + s * (c(3, i) + rest * c(4, i))));
}

}  // namespace armlet
