#include "armlet/math/check_finite.hpp"

#include <fmt/format.h>

#include <cmath>

namespace armlet {

void check_finite(std::string_view name, const Eigen::Ref<const Eigen::MatrixXd>& values) {
  for (Eigen::Index col = 0; col < values.cols(); ++col) {
    for (Eigen::Index row = 0; row < values.rows(); ++row) {
      const double value = values(row, col);
      if (std::isfinite(value)) continue;
      const std::string place = values.cols() == 1 ? fmt::format("Element {}", row)
                                                   : fmt::format("Element ({}, {})", row, col);
      throw ArgumentError(fmt::format("{} of `{}` is {}; it must be a finite number.", place, name,
                                      std::isnan(value) ? std::abs(value) : value));
    }
  }
}

}  // namespace armlet
