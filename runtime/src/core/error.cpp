#include "armlet/core/error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace armlet {

void check_size(std::string_view name, Eigen::Index given, Eigen::Index expected) {
  if (given == expected) return;
  throw ArgumentError(fmt::format("`{}` has {} element{}; expected {}.", name, given,
                                  given == 1 ? "" : "s", expected));
}

void check_finite(std::string_view name, double value) {
  if (std::isfinite(value)) return;
  throw ArgumentError(fmt::format("`{}` is {}; it must be a finite number.", name, value));
}

void check_finite(std::string_view name, const Eigen::Ref<const Eigen::MatrixXd>& values) {
  for (Eigen::Index col = 0; col < values.cols(); ++col) {
    for (Eigen::Index row = 0; row < values.rows(); ++row) {
      if (std::isfinite(values(row, col))) continue;
      const std::string place = values.cols() == 1 ? fmt::format("Element {}", row)
                                                   : fmt::format("Element ({}, {})", row, col);
      throw ArgumentError(fmt::format("{} of `{}` is {}; it must be a finite number.", place, name,
                                      values(row, col)));
    }
  }
}

void check_positive(std::string_view name, double value) {
  check_finite(name, value);
  if (value > 0.0) return;
  throw ArgumentError(fmt::format("`{}` is {}; it must be greater than zero.", name, value));
}

}  // namespace armlet
