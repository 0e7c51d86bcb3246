// Matrices put together, summed up, and taken element by element; and the matrices of a posC
// (language reference, sections 8 and 19).

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "armlet/math/det_math.hpp"
#include "armlet/math/rotation.hpp"
#include "blocks.hpp"
#include "matrices.hpp"
#include "values.hpp"

namespace armlet::bind {
namespace {

// ---- side by side ------------------------------------------------------------------------------

// A matrix, or a list as a column or a row.
struct Block {
  std::size_t rows = 0;
  std::size_t cols = 0;
  const double* data = nullptr;
};
Block block_of(const MatrixObj& A) { return {A.rows, A.cols, A.data()}; }
Block column_of(Slot list) { return {reals_value(list).size(), 1, reals_value(list).data()}; }
Block row_of(Slot list) { return {1, reals_value(list).size(), reals_value(list).data()}; }

MatrixObj* new_joined(Vm& vm, std::size_t rows, std::size_t cols) {
  const auto r = static_cast<std::int64_t>(rows);
  const auto c = static_cast<std::int64_t>(cols);
  if (!possible_size(vm, r, c, -1)) return nullptr;
  return new_matrix_unset(vm, static_cast<std::uint32_t>(rows), static_cast<std::uint32_t>(cols));
}

std::string block_size(const Block& block) {
  return size_text(static_cast<std::int64_t>(block.rows), static_cast<std::int64_t>(block.cols));
}

Signal beside(Vm& vm, Slot* args, std::span<const Block> blocks) {
  std::size_t cols = 0;
  for (const Block& block : blocks) {
    if (block.rows != blocks[0].rows) {
      return sizes_differ(vm, fmt::format("{} beside {}", block_size(blocks[0]), block_size(block)),
                          -1, "hcat needs equally many rows everywhere");
    }
    cols += block.cols;
  }
  const std::size_t rows = blocks.empty() ? 0 : blocks[0].rows;
  MatrixObj* A = new_joined(vm, rows, cols);
  if (A == nullptr) return Signal::kFail;
  double* to = A->data();
  const auto copy = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (const Block& block : blocks)
        to = std::copy_n(block.data + i * block.cols, block.cols, to);
    }
  };
  const unsigned cost = 16 + kCost * std::min(A->cols, 100'000'000U);
  if (in_blocks(vm, rows, cost, copy)) return give(args, A);
  release(vm, A);
  return Signal::kFail;
}

Signal above_each_other(Vm& vm, Slot* args, std::span<const Block> blocks) {
  std::size_t rows = 0;
  for (const Block& block : blocks) {
    if (block.cols != blocks[0].cols) {
      return sizes_differ(vm, fmt::format("{} above {}", block_size(blocks[0]), block_size(block)),
                          -1, "vcat needs equally many columns everywhere");
    }
    rows += block.rows;
  }
  MatrixObj* A = new_joined(vm, rows, blocks.empty() ? 0 : blocks[0].cols);
  if (A == nullptr) return Signal::kFail;
  double* to = A->data();
  for (const Block& block : blocks) {
    const std::size_t count = block.rows * block.cols;
    const auto copy = [&](std::size_t begin, std::size_t end) {
      std::copy(block.data + begin, block.data + end, to + begin);
    };
    if (!in_blocks(vm, count, kCost, copy)) {
      release(vm, A);
      return Signal::kFail;
    }
    to += count;
  }
  return give(args, A);
}

using Join = Signal (*)(Vm&, Slot*, std::span<const Block>);
using ListBlock = Block (*)(Slot);

template <Join kJoin>
Signal join_two(Vm& vm, Slot* args) {
  const std::array<Block, 2> blocks = {block_of(matrix_value(args[0])),
                                       block_of(matrix_value(args[1]))};
  return kJoin(vm, args, blocks);
}
template <Join kJoin, ListBlock kList>
Signal join_matrix_and_list(Vm& vm, Slot* args) {
  const std::array<Block, 2> blocks = {block_of(matrix_value(args[0])), kList(args[1])};
  return kJoin(vm, args, blocks);
}
template <Join kJoin, ListBlock kList>
Signal join_list_and_matrix(Vm& vm, Slot* args) {
  const std::array<Block, 2> blocks = {kList(args[0]), block_of(matrix_value(args[1]))};
  return kJoin(vm, args, blocks);
}
template <Join kJoin>
Signal join_all(Vm& vm, Slot* args) {
  const auto items = items_value(args[0]);
  const Scratch scratch(vm, items.size() * sizeof(Block));
  if (!scratch.granted()) return Signal::kFail;
  std::vector<Block> blocks;
  blocks.reserve(items.size());
  const auto take = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) blocks.push_back(block_of(matrix_value(items[i])));
  };
  return in_blocks(vm, items.size(), 8, take) ? kJoin(vm, args, blocks) : Signal::kFail;
}

// ---- one number --------------------------------------------------------------------------------

Answer<double> frobenius(Vm& vm, const MatrixObj& _a) {
  double length = 0.0;
  const bool done = length_of(vm, elements(_a), length);
  if (!(done)) return Failed{};
  return length;
}

bool total(Vm& vm, const MatrixObj& A, double& sum) {
  sum = 0.0;
  return in_blocks(vm, count_of(A), kCost, [&](std::size_t begin, std::size_t end) {
    for (const double x : elements(A).subspan(begin, end - begin)) sum += x;
  });
}
Answer<double> sum_of(Vm& vm, const MatrixObj& _a) {
  double sum = 0.0;
  if (!(total(vm, _a, sum))) return Failed{};
  return sum;
}

bool has_elements(Vm& vm, const MatrixObj& A, std::string_view what) {
  if (count_of(A) > 0) return true;
  (void)failure(vm, "R0613", fmt::format("a matrix without values has no {}", what), 0);
  return false;
}
Answer<double> mean_of(Vm& vm, const MatrixObj& A) {
  if (!has_elements(vm, A, "mean")) return Failed{};
  double sum = 0.0;
  if (!total(vm, A, sum)) return Failed{};
  return sum / static_cast<double>(count_of(A));
}
template <bool kMax>
Answer<double> extreme(Vm& vm, const MatrixObj& A) {
  if (!has_elements(vm, A, kMax ? "largest value" : "smallest value")) return Failed{};
  double best = A.data()[0];
  const auto look = [&](std::size_t begin, std::size_t end) {
    for (const double x : elements(A).subspan(begin, end - begin)) {
      if (kMax ? x > best : x < best) best = x;
    }
  };
  if (!(in_blocks(vm, count_of(A), kCost, look))) return Failed{};
  return best;
}

// ---- element by element ------------------------------------------------------------------------

using Real1 = double (*)(double);

template <Real1 kFunction>
Answer<Obj*> each(Vm& vm, const MatrixObj& A) {
  MatrixObj* B = new_matrix_unset(vm, A.rows, A.cols);
  if (B == nullptr) return Failed{};
  const auto compute = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double x = A.data()[i];
      B->data()[i] = kFunction(x);
      if (!std::isnan(B->data()[i]) || std::isnan(x)) continue;
      (void)failure(vm, "R0609",
                    fmt::format("element [{}, {}] of the matrix is {:.15g}, where the function has "
                                "no value",
                                i / A.cols, i % A.cols, x),
                    0);
      return false;
    }
    return true;
  };
  if (in_blocks(vm, count_of(A), kFunctionCost, compute)) return B;
  release(vm, B);
  return Failed{};
}

double absolute(double x) { return std::abs(x); }
double square_root(double x) { return x >= 0.0 ? std::sqrt(x) : std::nan(""); }
double round_down(double x) { return std::floor(x); }
double round_up(double x) { return std::ceil(x); }

// ---- the matrices of a posC --------------------------------------------------------------------

template <class Matrix>
Signal give_fixed(Vm& vm, Slot* args, const Matrix& A) {
  MatrixObj* out = new_matrix_unset(vm, Matrix::RowsAtCompileTime, Matrix::ColsAtCompileTime);
  if (out == nullptr) return Signal::kFail;
  for (int i = 0; i < A.rows(); ++i) {
    for (int j = 0; j < A.cols(); ++j) out->data()[i * A.cols() + j] = A(i, j);
  }
  return give(args, out);
}
Signal posc_rotation(Vm& vm, Slot* args) {
  return give_fixed(vm, args, Eigen::Matrix3d(posc(args[0]).T.linear()));
}
Signal posc_transform(Vm& vm, Slot* args) {
  return give_fixed(vm, args, Eigen::Matrix4d(posc(args[0]).T.matrix()));
}

// The rotation that a matrix holds; numbers that were written with few digits are turned into an
// exact one. Empty: the failure is set, for argument `argument`.
std::optional<Eigen::Matrix3d> rotation_of(Vm& vm, const MatrixObj& given, int argument) {
  constexpr double kNearly = 1e-3;
  const auto refuse = [](Signal) { return std::nullopt; };
  if (given.rows != 3 || given.cols != 3)
    return refuse(sizes_differ(
        vm, fmt::format("a rotation is 3x3, this is {}", size_text(given.rows, given.cols)),
        argument));
  Eigen::Matrix3d R;
  for (int i = 0; i < 9; ++i) {
    const double x = given.data()[i];
    if (!std::isfinite(x))
      return refuse(
          not_finite(vm, fmt::format("element [{}, {}] of the matrix", i / 3, i % 3), x, argument));
    R(i / 3, i % 3) = x;
  }
  const double error = (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(error <= kNearly)) {
    return refuse(
        failure(vm, "R0609", "this matrix is no rotation", argument,
                fmt::format("R.T * R differs from eye(3) by {:.3g}; at most {} is allowed", error,
                            kNearly)));
  }
  if (R.determinant() < 0.0) {
    return refuse(failure(vm, "R0609", "this matrix mirrors; it is no rotation", argument,
                          "its determinant is -1"));
  }
  return renormalised(R);
}

Answer<PosC> posc_from_rotation(Vm& vm, const MatrixObj& _r, std::span<const double> p) {
  const auto R = rotation_of(vm, _r, 0);
  if (!R) return Failed{};
  if (p.size() != 3) return sizes_differ(vm, fmt::format("a place has 3 values, not {}", p.size()));
  for (const double x : p) {
    if (!std::isfinite(x)) return not_finite(vm, "a value of the place", x, 1);
  }
  PosC pose;
  pose.T.linear() = *R;
  pose.T.translation() = Eigen::Vector3d(p[0], p[1], p[2]);
  pose.has_orientation = true;
  return pose;
}

Answer<PosC> posc_with_rotation(Vm& vm, const PosC& p, const MatrixObj& _r) {
  const auto R = rotation_of(vm, _r, 1);
  if (!R) return Failed{};
  PosC pose = p;
  pose.T.linear() = *R;
  pose.has_orientation = true;
  return pose;
}

constexpr NativeFunction kMatrixPartsFunctions[] = {
    {"hcat", "(A: matrix, B: matrix) -> matrix", "Two matrices side by side.",
     "hcat([1, 2; 3, 4], eye(2))", join_two<beside>},
    {"hcat", "(A: matrix, v: double[]) -> matrix", "A matrix with a column more.",
     "hcat([1, 2; 3, 4], [5.0, 6.0])", join_matrix_and_list<beside, column_of>},
    {"hcat", "(v: double[], A: matrix) -> matrix", "A column in front of a matrix.",
     "hcat([5.0, 6.0], [1, 2; 3, 4])", join_list_and_matrix<beside, column_of>},
    {"hcat", "(parts: matrix[]) -> matrix", "Matrices side by side.", "hcat([eye(2), eye(2)])",
     join_all<beside>},
    {"vcat", "(A: matrix, B: matrix) -> matrix", "One matrix above another.",
     "vcat([1, 2; 3, 4], eye(2))", join_two<above_each_other>},
    {"vcat", "(A: matrix, v: double[]) -> matrix", "A matrix with a row more.",
     "vcat([1, 2; 3, 4], [5.0, 6.0])", join_matrix_and_list<above_each_other, row_of>},
    {"vcat", "(v: double[], A: matrix) -> matrix", "A row above a matrix.",
     "vcat([5.0, 6.0], [1, 2; 3, 4])", join_list_and_matrix<above_each_other, row_of>},
    {"vcat", "(parts: matrix[]) -> matrix", "Matrices one above the other.",
     "vcat([eye(2), eye(2)])", join_all<above_each_other>},
    def<frobenius>("norm(A: matrix) -> double", "The root of the sum of all squares.",
                   "norm([1, 2; 3, 4])"),
    def<sum_of>("sum(A: matrix) -> double", "The sum of all values.", "sum([1, 2; 3, 4])"),
    def<mean_of>("mean(A: matrix) -> double", "The mean of all values.", "mean([1, 2; 3, 4])"),
    def<extreme<false>>("min(A: matrix) -> double", "The smallest value.", "min([1, 2; 3, 4])"),
    def<extreme<true>>("max(A: matrix) -> double", "The largest value.", "max([1, 2; 3, 4])"),
    def<each<absolute>>("abs(A: matrix) -> matrix", "Absolute value of each element.",
                        "abs([-1, 2; 3, -4])", {.check = check_same_size}),
    def<each<square_root>>("sqrt(A: matrix) -> matrix", "Square root of each element.",
                           "sqrt([1, 4; 9, 16])", {.check = check_same_size}),
    def<each<det::exp>>("exp(A: matrix) -> matrix",
                        "e to the power of each element; expm is the exponential of the matrix.",
                        "exp([0, 1; 2, 3])", {.check = check_same_size}),
    def<each<det::log>>("log(A: matrix) -> matrix", "Natural logarithm of each element.",
                        "log([1, 2; 3, 4])", {.check = check_same_size}),
    def<each<det::sin>>("sin(A: matrix) -> matrix", "Sine of each element, in radians.",
                        "sin([0, 1; 2, 3])", {.check = check_same_size}),
    def<each<det::cos>>("cos(A: matrix) -> matrix", "Cosine of each element, in radians.",
                        "cos([0, 1; 2, 3])", {.check = check_same_size}),
    def<each<det::tan>>("tan(A: matrix) -> matrix", "Tangent of each element, in radians.",
                        "tan([0, 1; 2, 3])", {.check = check_same_size}),
    def<each<round_down>>("floor(A: matrix) -> matrix",
                          "The whole number at or below each element.", "floor([1.5, 2.5; 3, 4])",
                          {.check = check_same_size}),
    def<each<round_up>>("ceil(A: matrix) -> matrix", "The whole number at or above each element.",
                        "ceil([1.5, 2.5; 3, 4])", {.check = check_same_size}),
    {"posC.R", "(p: posC) -> matrix", "The orientation as a 3x3 rotation.", "rotZ(90deg).R",
     posc_rotation},
    def<posc_with_rotation>("posC.R=(p: posC, R: matrix) -> posC",
                            "The orientation changed to a rotation.",
                            "var p = here(); p.R = rotX(90deg).R"),
    {"posC.T", "(p: posC) -> matrix", "The 4x4 matrix of the whole, lengths in metres.",
     "xyz(1m, 2m, 3m).T", posc_transform},
    def<posc_from_rotation>("posC(R: matrix, p: length[]) -> posC",
                            "An orientation as a rotation, and a place.",
                            "posC(eye(3), [100mm, 0mm, 50mm])"),
    def<posc_from_rotation>("posC(R: matrix, p: double[]) -> posC",
                            "An orientation as a rotation, and a place in metres.",
                            "posC(eye(3), [0.1, 0.0, 0.05])"),
};

}  // namespace

std::span<const NativeFunction> matrix_part_functions() { return kMatrixPartsFunctions; }

}  // namespace armlet::bind
