#include "armlet/core/error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace armlet {

void refuse_argument(const std::string& message) { throw ArgumentError(message); }

void check_size(std::string_view name, std::ptrdiff_t given, std::ptrdiff_t expected) {
  if (given == expected) return;
  throw ArgumentError(fmt::format("`{}` has {} element{}; expected {}.", name, given,
                                  given == 1 ? "" : "s", expected));
}

void check_finite(std::string_view name, double value) {
  if (std::isfinite(value)) return;
  throw ArgumentError(fmt::format("`{}` is {}; it must be a finite number.", name,
                                  std::isnan(value) ? std::abs(value) : value));
}

void check_positive(std::string_view name, double value) {
  check_finite(name, value);
  if (value > 0.0) return;
  throw ArgumentError(fmt::format("`{}` is {}; it must be greater than zero.", name, value));
}

}  // namespace armlet
