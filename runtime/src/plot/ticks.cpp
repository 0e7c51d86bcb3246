#include "armlet/plot/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "armlet/math/det_math.hpp"
#include "powers.hpp"

namespace armlet {
namespace {

// A step may be smaller than requested by this factor.
constexpr double kShare = 0.8;

// The exponent k of the decimal form d.ddd * 10^k.
int decimal_exponent(double x) {
  const std::string text = fmt::format("{:e}", x);
  int exponent = 0;
  const char* begin = text.data() + text.find('e') + 1;
  if (*begin == '+') ++begin;
  std::from_chars(begin, text.data() + text.size(), exponent);
  return exponent;
}

// The step digits * 10^exponent.
struct Step {
  double digits = 1.0;
  int exponent = 0;
  double value() const {
    return exponent >= 0 ? digits * power_of_ten(exponent) : digits / power_of_ten(-exponent);
  }
  double times(double k) const {
    return exponent >= 0 ? k * digits * power_of_ten(exponent)
                         : k * digits / power_of_ten(-exponent);
  }
};

Step step_for(double span, int wanted, bool degrees) {
  const double raw = span / wanted;
  if (degrees && raw > 5.0 && raw <= 360.0) {
    for (const double digits : {10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 180.0, 360.0}) {
      if (digits >= kShare * raw) return {digits, 0};
    }
  }
  const int exponent = std::max(decimal_exponent(raw), -300);
  for (const double digits : {1.0, 2.0, 5.0}) {
    const Step step{digits, exponent};
    if (step.value() >= kShare * raw) return step;
  }
  return {1.0, exponent + 1};
}

// Widens the range to both sides if all values are the same.
void make_room(double& lower, double& upper) {
  const double largest = std::max(std::abs(lower), std::abs(upper));
  // Values that differ by less than their last shown digit count as the same.
  const double room = std::max(largest * 1e-9, 1e-290);
  if (upper - lower >= room) return;
  const double half = largest > 1e-280 ? largest * 0.05 : 1.0;
  lower -= half;
  upper += half;
}

std::string label(double value, const Step& step, double largest) {
  if (value == 0.0) return "0";
  if (largest >= 1e6 || step.exponent < -5) return fmt::format("{:.6g}", value);
  return fmt::format("{:.{}f}", value, std::max(0, -step.exponent));
}

// Ticks at first, first + 1, ... last times the step.
void place(Ticks& ticks, const Step& step, double first, double last) {
  const double largest = std::max(std::abs(ticks.lower), std::abs(ticks.upper));
  for (int k = 0; first + k <= last && k < 64; ++k) {
    const double value = step.times(first + k);
    ticks.at.push_back(value == 0.0 ? 0.0 : value);
    ticks.labels.push_back(label(value, step, largest));
  }
}

// The next larger round step.
Step next(const Step& step, bool degrees) {
  if (degrees && step.value() >= 10.0 && step.value() < 360.0) {
    for (const double digits : {10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 180.0, 360.0}) {
      if (digits > step.value()) return {digits, 0};
    }
  }
  if (step.digits == 1.0) return {2.0, step.exponent};
  if (step.digits == 2.0) return {25.0, step.exponent - 1};
  if (step.digits == 25.0) return {5.0, step.exponent + 1};
  if (step.digits == 5.0) return {1.0, step.exponent + 1};
  return {2.0 * step.digits, step.exponent};
}

// The first tick of an axis with this number of steps that encloses the values, in steps: with its
// zero at tick `zero`, or anywhere if that is less than 0.
std::optional<double> first_tick(double lower, double upper, double steps, double zero,
                                 const Step& step) {
  const double slack = 1e-9 * (upper - lower);
  const double first = zero >= 0.0 ? -zero : std::floor(lower / step.value() + 1e-9);
  const bool encloses =
      step.times(first) <= lower + slack && step.times(first + steps) >= upper - slack;
  return encloses ? std::optional<double>(first) : std::nullopt;
}

}  // namespace

double Ticks::position(double value) const {
  if (!log) return (value - lower) / (upper - lower);
  return (det::log(value) - det::log(lower)) / (det::log(upper) - det::log(lower));
}

Ticks make_ticks(double lower, double upper, int wanted, bool degrees, bool whole) {
  wanted = std::clamp(wanted, 2, 12);
  make_room(lower, upper);
  const Step step = step_for(upper - lower, wanted, degrees);
  double first = std::ceil(lower / step.value() - 1e-9),
         last = std::floor(upper / step.value() + 1e-9);
  if (whole) {
    first = std::floor(lower / step.value() + 1e-9);
    last = std::ceil(upper / step.value() - 1e-9);
    lower = step.times(first);
    upper = step.times(last);
  }
  Ticks ticks{lower, upper, {}, {}};
  place(ticks, step, first, last);
  return ticks;
}

Ticks make_parallel_ticks(double lower, double upper, const Ticks& other, bool degrees) {
  make_room(lower, upper);
  const double steps = static_cast<double>(other.at.size()) - 1.0;
  const auto found = std::ranges::find(other.at, 0.0);
  const bool has_zero = found != other.at.end() && lower <= 0.0 && upper >= 0.0;
  // Longer steps are tried to align the zeros, but not if most of the axis stays empty.
  constexpr double kMost = 3.0;
  for (const double zero :
       {has_zero ? static_cast<double>(found - other.at.begin()) : -1.0, -1.0}) {
    Step step = step_for((upper - lower) / kShare, static_cast<int>(steps), degrees);
    for (int tried = 0; tried < 4; ++tried, step = next(step, degrees)) {
      const auto first = first_tick(lower, upper, steps, zero, step);
      if (!first || (zero >= 0.0 && steps * step.value() > kMost * (upper - lower))) continue;
      Ticks ticks{step.times(*first), step.times(*first + steps), {}, {}};
      place(ticks, step, *first, *first + steps);
      return ticks;
    }
  }
  return make_ticks(lower, upper, static_cast<int>(steps), degrees, true);
}

Ticks make_name_ticks(const std::vector<std::string>& names) {
  Ticks ticks{-0.5, static_cast<double>(names.size()) - 0.5, {}, names};
  for (std::size_t i = 0; i < names.size(); ++i) ticks.at.push_back(static_cast<double>(i));
  return ticks;
}

}  // namespace armlet
