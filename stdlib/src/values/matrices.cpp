#include "values/matrices.hpp"

#include <fmt/format.h>

#include <cmath>

namespace armlet::bind {

std::string size_text(std::int64_t rows, std::int64_t cols) {
  return fmt::format("{}x{}", rows, cols);
}

std::string values_text(std::int64_t count) {
  return fmt::format("{} value{}", count, count == 1 ? "" : "s");
}

Failed sizes_differ(Vm& vm, const std::string& sizes, CallPart part, std::string fix) {
  Failure f;
  f.headline = {"R0613", {sizes}};
  f.mark = part;
  f.fix = std::move(fix);
  return fail(vm, std::move(f));
}

Failed not_square(Vm& vm, std::string_view function, const MatrixObj& A) {
  return failure(vm, "R0613",
                 fmt::format("{} needs a square matrix, but this one is {}", function,
                             size_text(A.rows, A.cols)),
                 CallPart::first());
}

Answer<void> possible_size(Vm& vm, std::int64_t rows, std::int64_t cols, CallPart part) {
  constexpr std::int64_t kMost = 100'000'000;
  if (rows >= 0 && cols >= 0 && rows <= kMost && cols <= kMost &&
      (cols == 0 || rows <= kMost / cols)) {
    return {};
  }
  const bool negative = rows < 0 || cols < 0;
  return failure(vm, "R0613",
                 fmt::format("a matrix cannot have {} rows and {} columns", rows, cols), part,
                 negative ? "" : fmt::format("a matrix has at most {} values", kMost));
}

bool length_of(Vm& vm, std::span<const double> values, double& length) {
  double scale = 0.0;
  double sum = 1.0;
  const auto add = [&](std::size_t begin, std::size_t end) {
    for (const double x : values.subspan(begin, end - begin)) {
      const double size = std::abs(x);
      if (size == 0.0) continue;
      if (scale < size) {
        sum = 1.0 + sum * (scale / size) * (scale / size);
        scale = size;
      } else {
        sum += (size / scale) * (size / scale);
      }
    }
  };
  if (!in_blocks(vm, values.size(), 8, add)) return false;
  length = scale * std::sqrt(sum);
  return true;
}

}  // namespace armlet::bind
