#pragma once

#include <fmt/format.h>

#include <charconv>
#include <string>

namespace armlet {

// 10^k, rounded once, without logarithm or power of the C library, whose last bits differ between
// machines.
inline double power_of_ten(int k) {
  const std::string text = fmt::format("1e{}", k);
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace armlet
