#include "armlet/plot/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace armlet {
namespace {

// A step may be this much smaller than asked for.
constexpr double kShare = 0.8;

// 10^k, rounded once; no logarithm or power of the C library, whose last bits differ.
double power_of_ten(int k) {
  const std::string text = fmt::format("1e{}", k);
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

// The exponent k of the decimal form d.ddd * 10^k.
int decimal_exponent(double x) {
  const std::string text = fmt::format("{:e}", x);
  int exponent = 0;
  const char* begin = text.data() + text.find('e') + 1;
  if (*begin == '+') ++begin;
  std::from_chars(begin, text.data() + text.size(), exponent);
  return exponent;
}

// step = digits * 10^exponent
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

std::string label(double value, const Step& step, double largest) {
  if (value == 0.0) return "0";
  if (largest >= 1e6 || step.exponent < -5) return fmt::format("{:.6g}", value);
  return fmt::format("{:.{}f}", value, std::max(0, -step.exponent));
}

}  // namespace

Ticks make_ticks(double lower, double upper, int wanted, bool degrees, bool whole) {
  wanted = std::clamp(wanted, 2, 12);
  const double largest = std::max(std::abs(lower), std::abs(upper));
  // Values that differ by less than their last digits show are the same.
  const double room = std::max(largest * 1e-9, 1e-290);
  if (upper - lower < room) {
    const double half = largest > 1e-280 ? largest * 0.05 : 1.0;
    lower -= half;
    upper += half;
  }
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
  for (int k = 0; first + k <= last && k < 64; ++k) {
    const double value = step.times(first + k);
    ticks.at.push_back(value == 0.0 ? 0.0 : value);
    ticks.labels.push_back(label(value, step, std::max(std::abs(lower), std::abs(upper))));
  }
  return ticks;
}

}  // namespace armlet
