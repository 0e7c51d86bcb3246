// Matrices joined, reduced to one number, and computed element by element; and the matrices of a
// posC (language reference, sections 8 and 19).

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "armlet/math/det_math.hpp"
#include "armlet/math/rotation.hpp"
#include "numbers/real_functions.hpp"
#include "rules/matrix_rules.hpp"
#include "values/blocks.hpp"
#include "values/eigen_results.hpp"
#include "values/matrices.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

// ---- joining -----------------------------------------------------------------------------------

// A part to join: a matrix, or a list as a column or a row.
struct Block {
  std::size_t rows = 0;
  std::size_t cols = 0;
  const double* data = nullptr;
};
Block block_of(const MatrixObj& A) { return {A.rows, A.cols, A.data()}; }
Block column_of(std::span<const double> list) { return {list.size(), 1, list.data()}; }
Block row_of(std::span<const double> list) { return {1, list.size(), list.data()}; }

MatrixObj* new_joined(Vm& vm, std::size_t rows, std::size_t cols) {
  const auto r = static_cast<std::int64_t>(rows);
  const auto c = static_cast<std::int64_t>(cols);
  if (!possible_size(vm, r, c, {})) return nullptr;
  return new_matrix_unset(vm, static_cast<std::uint32_t>(rows), static_cast<std::uint32_t>(cols));
}

std::string block_size(const Block& block) {
  return size_text(static_cast<std::int64_t>(block.rows), static_cast<std::int64_t>(block.cols));
}

Answer<MatrixObj*> beside(Vm& vm, std::span<const Block> blocks) {
  std::size_t cols = 0;
  for (const Block& block : blocks) {
    if (block.rows != blocks[0].rows) {
      return sizes_differ(vm, fmt::format("{} beside {}", block_size(blocks[0]), block_size(block)),
                          {}, "hcat needs equally many rows everywhere");
    }
    cols += block.cols;
  }
  const std::size_t rows = blocks.empty() ? 0 : blocks[0].rows;
  MatrixObj* A = new_joined(vm, rows, cols);
  if (A == nullptr) return Failed{};
  double* to = A->data();
  const auto copy = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (const Block& block : blocks)
        to = std::copy_n(block.data + i * block.cols, block.cols, to);
    }
  };
  const unsigned cost = 16 + kCost * std::min(A->cols, 100'000'000U);
  if (in_blocks(vm, rows, cost, copy)) return A;
  release(vm, A);
  return Failed{};
}

Answer<MatrixObj*> above_each_other(Vm& vm, std::span<const Block> blocks) {
  std::size_t rows = 0;
  for (const Block& block : blocks) {
    if (block.cols != blocks[0].cols) {
      return sizes_differ(vm, fmt::format("{} above {}", block_size(blocks[0]), block_size(block)),
                          {}, "vcat needs equally many columns everywhere");
    }
    rows += block.rows;
  }
  MatrixObj* A = new_joined(vm, rows, blocks.empty() ? 0 : blocks[0].cols);
  if (A == nullptr) return Failed{};
  double* to = A->data();
  for (const Block& block : blocks) {
    const std::size_t count = block.rows * block.cols;
    const auto copy = [&](std::size_t begin, std::size_t end) {
      std::copy(block.data + begin, block.data + end, to + begin);
    };
    if (!in_blocks(vm, count, kCost, copy)) {
      release(vm, A);
      return Failed{};
    }
    to += count;
  }
  return A;
}

using Join = Answer<MatrixObj*> (*)(Vm&, std::span<const Block>);
using ListBlock = Block (*)(std::span<const double>);

template <Join kJoin>
Answer<MatrixObj*> join_two(Vm& vm, const MatrixObj& A, const MatrixObj& B) {
  return kJoin(vm, std::array{block_of(A), block_of(B)});
}
template <Join kJoin, ListBlock kList>
Answer<MatrixObj*> join_matrix_and_list(Vm& vm, const MatrixObj& A, std::span<const double> v) {
  return kJoin(vm, std::array{block_of(A), kList(v)});
}
template <Join kJoin, ListBlock kList>
Answer<MatrixObj*> join_list_and_matrix(Vm& vm, std::span<const double> v, const MatrixObj& A) {
  return kJoin(vm, std::array{kList(v), block_of(A)});
}
template <Join kJoin>
Answer<MatrixObj*> join_all(Vm& vm, std::span<const Slot> items) {
  const Scratch scratch(vm, items.size() * sizeof(Block));
  if (!scratch.granted()) return Failed{};
  std::vector<Block> blocks;
  blocks.reserve(items.size());
  const auto take = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) blocks.push_back(block_of(matrix_value(items[i])));
  };
  if (!in_blocks(vm, items.size(), 8, take)) return Failed{};
  return kJoin(vm, blocks);
}

// ---- reductions --------------------------------------------------------------------------------

Answer<double> frobenius(Vm& vm, const MatrixObj& A) {
  double length = 0.0;
  if (!length_of(vm, elements(A), length)) return Failed{};
  return length;
}

Answer<double> sum_of(Vm& vm, const MatrixObj& A) {
  double sum = 0.0;
  const auto add = [&](std::size_t begin, std::size_t end) {
    for (const double x : elements(A).subspan(begin, end - begin)) sum += x;
  };
  if (!in_blocks(vm, count_of(A), kCost, add)) return Failed{};
  return sum;
}

Answer<void> require_elements(Vm& vm, const MatrixObj& A, std::string_view what) {
  if (count_of(A) > 0) return {};
  return failure(vm, "R0613", fmt::format("a matrix without values has no {}", what),
                 CallPart::first());
}
Answer<double> mean_of(Vm& vm, const MatrixObj& A) {
  if (!require_elements(vm, A, "mean")) return Failed{};
  const Answer<double> sum = sum_of(vm, A);
  if (!sum) return Failed{};
  return *sum / static_cast<double>(count_of(A));
}
template <bool kMax>
Answer<double> extreme_element(Vm& vm, const MatrixObj& A) {
  if (!require_elements(vm, A, kMax ? "largest value" : "smallest value")) return Failed{};
  double best = A.data()[0];
  const auto look = [&](std::size_t begin, std::size_t end) {
    for (const double x : elements(A).subspan(begin, end - begin)) {
      if (kMax ? x > best : x < best) best = x;
    }
  };
  if (!in_blocks(vm, count_of(A), kCost, look)) return Failed{};
  return best;
}

// ---- element by element ------------------------------------------------------------------------

template <Real1 kFunction>
Answer<MatrixObj*> each_element(Vm& vm, const MatrixObj& A) {
  MatrixObj* B = new_matrix_unset(vm, A.rows, A.cols);
  if (B == nullptr) return Failed{};
  std::size_t bad = count_of(A);
  const auto compute = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && bad == count_of(A); ++i) {
      B->data()[i] = kFunction(A.data()[i]);
      if (std::isnan(B->data()[i]) && !std::isnan(A.data()[i])) bad = i;
    }
    return bad == count_of(A);
  };
  if (in_blocks(vm, count_of(A), kFunctionCost, compute)) return B;
  release(vm, B);
  if (bad == count_of(A)) return Failed{};
  return failure(vm, "R0609",
                 fmt::format("element [{}, {}] of the matrix is {:.15g}, where the function has no "
                             "value",
                             bad / A.cols, bad % A.cols, A.data()[bad]),
                 at("A"));
}

// ---- the matrices of a posC --------------------------------------------------------------------

Eigen::Matrix3d posc_rotation(const PosC& p) { return p.T.linear(); }
Eigen::Matrix4d posc_transform(const PosC& p) { return p.T.matrix(); }

// The rotation in a matrix; a matrix written with few digits is replaced by the nearest exact
// rotation; failures mark `part`.
Answer<Eigen::Matrix3d> rotation_of(Vm& vm, const MatrixObj& given, CallPart part) {
  constexpr double kNearly = 1e-3;
  if (given.rows != 3 || given.cols != 3)
    return sizes_differ(
        vm, fmt::format("a rotation is 3x3, this is {}", size_text(given.rows, given.cols)), part);
  Eigen::Matrix3d R;
  for (int i = 0; i < 9; ++i) {
    const double x = given.data()[i];
    if (!std::isfinite(x))
      return not_finite(vm, fmt::format("element [{}, {}] of the matrix", i / 3, i % 3), x, part);
    R(i / 3, i % 3) = x;
  }
  const double error = (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(error <= kNearly)) {
    return failure(vm, "R0609", "this matrix is no rotation", part,
                   fmt::format("R.T * R differs from eye(3) by {:.3g}; at most {} is allowed",
                               error, kNearly));
  }
  if (R.determinant() < 0.0) {
    return failure(vm, "R0609", "this matrix mirrors; it is no rotation", part,
                   "its determinant is -1");
  }
  return Eigen::Matrix3d(renormalised(R));
}

Answer<PosC> posc_from_rotation(Vm& vm, const MatrixObj& matrix, std::span<const double> p) {
  const auto R = rotation_of(vm, matrix, at("R"));
  if (!R) return Failed{};
  if (p.size() != 3)
    return sizes_differ(vm, fmt::format("a place has 3 values, not {}", p.size()), at("p"));
  for (const double x : p) {
    if (!std::isfinite(x)) return not_finite(vm, "a value of the place", x, at("p"));
  }
  PosC pose;
  pose.T.linear() = *R;
  pose.T.translation() = Eigen::Vector3d(p[0], p[1], p[2]);
  pose.has_orientation = true;
  return pose;
}

Answer<PosC> posc_with_rotation(Vm& vm, const PosC& p, const MatrixObj& matrix) {
  const auto R = rotation_of(vm, matrix, at("R"));
  if (!R) return Failed{};
  PosC pose = p;
  pose.T.linear() = *R;
  pose.has_orientation = true;
  return pose;
}

constexpr NativeFunction kMatrixPartsFunctions[] = {
    def<join_two<beside>>("hcat(A: matrix, B: matrix) -> matrix", "Two matrices side by side.",
                          "hcat([1, 2; 3, 4], eye(2))"),
    def<join_matrix_and_list<beside, column_of>>("hcat(A: matrix, v: double[]) -> matrix",
                                                 "A matrix with a column more.",
                                                 "hcat([1, 2; 3, 4], [5.0, 6.0])"),
    def<join_list_and_matrix<beside, column_of>>("hcat(v: double[], A: matrix) -> matrix",
                                                 "A column in front of a matrix.",
                                                 "hcat([5.0, 6.0], [1, 2; 3, 4])"),
    def<join_all<beside>>("hcat(parts: matrix[]) -> matrix", "Matrices side by side.",
                          "hcat([eye(2), eye(2)])"),
    def<join_two<above_each_other>>("vcat(A: matrix, B: matrix) -> matrix",
                                    "One matrix above another.", "vcat([1, 2; 3, 4], eye(2))"),
    def<join_matrix_and_list<above_each_other, row_of>>("vcat(A: matrix, v: double[]) -> matrix",
                                                        "A matrix with a row more.",
                                                        "vcat([1, 2; 3, 4], [5.0, 6.0])"),
    def<join_list_and_matrix<above_each_other, row_of>>("vcat(v: double[], A: matrix) -> matrix",
                                                        "A row above a matrix.",
                                                        "vcat([5.0, 6.0], [1, 2; 3, 4])"),
    def<join_all<above_each_other>>("vcat(parts: matrix[]) -> matrix",
                                    "Matrices one above the other.", "vcat([eye(2), eye(2)])"),
    def<frobenius>("norm(A: matrix) -> double", "The root of the sum of all squares.",
                   "norm([1, 2; 3, 4])"),
    def<sum_of>("sum(A: matrix) -> double", "The sum of all values.", "sum([1, 2; 3, 4])"),
    def<mean_of>("mean(A: matrix) -> double", "The mean of all values.", "mean([1, 2; 3, 4])"),
    def<extreme_element<false>>("min(A: matrix) -> double", "The smallest value.",
                                "min([1, 2; 3, 4])"),
    def<extreme_element<true>>("max(A: matrix) -> double", "The largest value.",
                               "max([1, 2; 3, 4])"),
    def<each_element<absolute>>("abs(A: matrix) -> matrix", "Absolute value of each element.",
                                "abs([-1, 2; 3, -4])", {.check = check_same_size}),
    def<each_element<square_root>>("sqrt(A: matrix) -> matrix", "Square root of each element.",
                                   "sqrt([1, 4; 9, 16])", {.check = check_same_size}),
    def<each_element<det::exp>>(
        "exp(A: matrix) -> matrix",
        "e to the power of each element; expm is the exponential of the matrix.",
        "exp([0, 1; 2, 3])", {.check = check_same_size}),
    def<each_element<det::log>>("log(A: matrix) -> matrix", "Natural logarithm of each element.",
                                "log([1, 2; 3, 4])", {.check = check_same_size}),
    def<each_element<det::sin>>("sin(A: matrix) -> matrix", "Sine of each element, in radians.",
                                "sin([0, 1; 2, 3])", {.check = check_same_size}),
    def<each_element<det::cos>>("cos(A: matrix) -> matrix", "Cosine of each element, in radians.",
                                "cos([0, 1; 2, 3])", {.check = check_same_size}),
    def<each_element<det::tan>>("tan(A: matrix) -> matrix", "Tangent of each element, in radians.",
                                "tan([0, 1; 2, 3])", {.check = check_same_size}),
    def<each_element<round_down>>("floor(A: matrix) -> matrix",
                                  "The whole number at or below each element.",
                                  "floor([1.5, 2.5; 3, 4])", {.check = check_same_size}),
    def<each_element<round_up>>("ceil(A: matrix) -> matrix",
                                "The whole number at or above each element.",
                                "ceil([1.5, 2.5; 3, 4])", {.check = check_same_size}),
    def<posc_rotation>("posC.R(p: posC) -> matrix", "The orientation as a 3x3 rotation.",
                       "rotZ(90deg).R"),
    def<posc_with_rotation>("posC.R=(p: posC, R: matrix) -> posC",
                            "The orientation changed to a rotation.",
                            "var p = here(); p.R = rotX(90deg).R"),
    def<posc_transform>("posC.T(p: posC) -> matrix",
                        "The 4x4 matrix of the whole, lengths in metres.", "xyz(1m, 2m, 3m).T"),
    def<posc_from_rotation>("posC(R: matrix, p: length[] | double[]) -> posC",
                            "An orientation as a rotation, and a position as lengths or in metres.",
                            "posC(eye(3), [100mm, 0mm, 50mm]); posC(eye(3), [0.1, 0.0, 0.05])"),
};

}  // namespace

std::span<const NativeFunction> matrix_part_functions() { return kMatrixPartsFunctions; }

}  // namespace armlet::bind
