// Ticks of logarithmic axes.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "armlet/plot/ticks.hpp"
#include "powers.hpp"

namespace armlet {
namespace {

// The number digits * 10^exponent, digits from 1 to 9.
struct Decimal {
  int digits = 1;
  int exponent = 0;

  double value() const {
    return exponent >= 0 ? digits * power_of_ten(exponent) : digits / power_of_ten(-exponent);
  }
};

// The largest power of ten that is not above x.
Decimal power_below(double x) {
  // All 17 digits, so that no value is rounded up to the next power.
  const std::string text = fmt::format("{:.16e}", x);
  int exponent = 0;
  const char* begin = text.data() + text.find('e') + 1;
  if (*begin == '+') ++begin;
  std::from_chars(begin, text.data() + text.size(), exponent);
  return {1, std::max(exponent, -307)};
}

Decimal next(const Decimal& d, bool whole_powers) {
  if (whole_powers || d.digits == 5) return {1, d.exponent + 1};
  return {d.digits == 1 ? 2 : 5, d.exponent};
}
Decimal before(const Decimal& d, bool whole_powers) {
  if (whole_powers || d.digits == 1) return {whole_powers ? 1 : 5, d.exponent - 1};
  return {d.digits == 5 ? 2 : 1, d.exponent};
}

std::string superscript(int number) {
  constexpr std::array<const char*, 10> kDigits = {"\u2070", "\u00b9", "\u00b2", "\u00b3",
                                                   "\u2074", "\u2075", "\u2076", "\u2077",
                                                   "\u2078", "\u2079"};
  std::string out;
  for (const char c : std::to_string(number))
    out += c == '-' ? "\u207b" : kDigits[static_cast<std::size_t>(c - '0')];
  return out;
}

std::string label(const Decimal& d, bool plain) {
  if (plain) return fmt::format("{:.{}f}", d.value(), std::max(0, -d.exponent));
  const std::string power = "10" + superscript(d.exponent);
  return d.digits == 1 ? power : fmt::format("{}\u00b7{}", d.digits, power);
}

}  // namespace

Ticks make_log_ticks(double lower, double upper, int wanted) {
  wanted = std::clamp(wanted, 2, 12);
  const bool whole_powers = upper / lower >= 100.0;
  Decimal first = power_below(lower);
  while (next(first, whole_powers).value() <= lower) first = next(first, whole_powers);
  if (lower == upper && first.value() == lower) first = before(first, whole_powers);
  Decimal last = first;
  while (last.value() < upper || last.value() <= lower) last = next(last, whole_powers);
  const int powers = last.exponent - first.exponent;
  const int stride = whole_powers ? 1 + (powers - 1) / wanted : 1;
  const bool plain = first.exponent >= -3 && last.exponent <= 4;
  Ticks ticks{first.value(), last.value(), {}, {}};
  ticks.log = true;
  for (Decimal d = first; d.value() <= ticks.upper; d = next(d, whole_powers)) {
    if (whole_powers && d.exponent % stride != 0) {
      ticks.minor.push_back(d.value());
      continue;
    }
    ticks.at.push_back(d.value());
    ticks.labels.push_back(label(d, plain));
  }
  if (stride > 1 || powers > 8) return ticks;
  for (int exponent = first.exponent; exponent <= last.exponent; ++exponent) {
    for (int digits = 2; digits < 10; ++digits) {
      const double value = Decimal{digits, exponent}.value();
      const bool is_tick = std::ranges::find(ticks.at, value) != ticks.at.end();
      if (value > ticks.lower && value < ticks.upper && !is_tick) ticks.minor.push_back(value);
    }
  }
  return ticks;
}

}  // namespace armlet
