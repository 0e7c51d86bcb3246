#pragma once
// Helpers shared by the functions of matrices: sizes as text, failures, charges for long work.

#include <cstdint>
#include <string>
#include <string_view>

#include "armlet/interpreter/work.hpp"
#include "values/bind.hpp"

namespace armlet::bind {

[[nodiscard]] inline std::size_t count_of(const MatrixObj& A) {
  return std::size_t{A.rows} * A.cols;
}
[[nodiscard]] inline std::span<const double> elements(const MatrixObj& A) {
  return {A.data(), count_of(A)};
}
// "3x4".
[[nodiscard]] std::string size_text(std::int64_t rows, std::int64_t cols);
// "1 value", "4 values".
[[nodiscard]] std::string values_text(std::int64_t count);

// R0613 "the sizes do not fit: 3x3 times 4", with an argument marked.
Failed sizes_differ(Vm& vm, const std::string& sizes, CallPart part, std::string fix = {});
// R0613 for a matrix that `function` needs to be square.
Failed not_square(Vm& vm, std::string_view function, const MatrixObj& A);
// Fails with R0613 unless a matrix of this size can be made.
Answer<void> possible_size(Vm& vm, std::int64_t rows, std::int64_t cols, CallPart part);

// The root of the sum of squares, scaled against overflow and underflow. False: the program must
// stop, and the failure is set.
[[nodiscard]] bool length_of(Vm& vm, std::span<const double> values, double& length);

}  // namespace armlet::bind
