#include "chain/batch_plan.hpp"

#include <fmt/format.h>

#include "armlet/core/error.hpp"

namespace armlet {

std::size_t count_configurations(std::span<const double> q, std::size_t n) {
  const std::size_t count = q.size() / n;
  if (count * n != q.size()) {
    throw ArgumentError(
        fmt::format("`q` has {} elements; expected a multiple of the {} joints.", q.size(), n));
  }
  return count;
}

}  // namespace armlet
