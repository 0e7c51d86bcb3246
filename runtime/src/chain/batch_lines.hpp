#pragma once

#include <Eigen/Core>
#include <span>

namespace armlet {

// The numbers of a batch: one row for each joint or entry, one configuration in each column.
using BatchLines = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

inline std::span<const double> numbers_of(const BatchLines& lines) {
  return {lines.data(), static_cast<std::size_t>(lines.size())};
}

}  // namespace armlet
