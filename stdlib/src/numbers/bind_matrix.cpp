// Matrices: construction and arithmetic (language reference, sections 8 and 19).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/math/det_math.hpp"
#include "armlet/math/matrix_product.hpp"
#include "rules/matrix_rules.hpp"
#include "values/blocks.hpp"
#include "values/matrices.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

// The new matrix A after fill(i, first, last) for parts of each row; rows may be long or many.
// Null, as A or as the result: it failed.
template <class F>
MatrixObj* with_rows(Vm& vm, MatrixObj* A, F fill) {
  if (A == nullptr) return nullptr;
  const std::size_t cols = A->cols;
  const auto rows = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) fill(i, std::size_t{0}, cols);
  };
  const auto parts_of_rows = [&] {
    for (std::size_t i = 0; i < A->rows; ++i) {
      const auto part = [&](std::size_t begin, std::size_t end) { fill(i, begin, end); };
      if (!in_blocks(vm, cols, kCost, part)) return false;
    }
    return true;
  };
  const bool long_rows = cols * kCost > kBlockWork;
  const bool done =
      long_rows ? parts_of_rows() : in_blocks(vm, A->rows, 16 + kCost * A->cols, rows);
  if (done) return A;
  release(vm, A);
  return nullptr;
}

// ---- construction ------------------------------------------------------------------------------

Answer<void> same_lengths(Vm& vm, std::span<const Slot> rows, std::size_t cols) {
  std::size_t odd = rows.size();
  const auto look = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && odd == rows.size(); ++i) {
      if (items_value(rows[i]).size() != cols) odd = i;
    }
    return odd == rows.size();
  };
  if (in_blocks(vm, rows.size(), 8, look)) return {};
  if (odd == rows.size()) return Failed{};
  const auto count = static_cast<std::int64_t>(items_value(rows[odd]).size());
  return sizes_differ(
      vm,
      fmt::format("row 0 has {}, row {} has {}", values_text(static_cast<std::int64_t>(cols)), odd,
                  values_text(count)),
      at("rows"));
}
template <bool kInts>
Answer<MatrixObj*> matrix_from(Vm& vm, std::span<const Slot> rows) {
  const std::size_t cols = rows.empty() ? 0 : items_value(rows[0]).size();
  if (!same_lengths(vm, rows, cols) ||
      !possible_size(vm, static_cast<std::int64_t>(rows.size()), static_cast<std::int64_t>(cols),
                     at("rows"))) {
    return Failed{};
  }
  MatrixObj* A = new_matrix_unset(vm, static_cast<std::uint32_t>(rows.size()),
                                  static_cast<std::uint32_t>(cols));
  double* to = A == nullptr ? nullptr : A->data();
  return with_rows(vm, A, [&](std::size_t i, std::size_t first, std::size_t last) {
    for (const Slot x : items_value(rows[i]).subspan(first, last - first))
      *to++ = kInts ? static_cast<double>(x.i) : x.d;
  });
}

template <int kValue>
Answer<MatrixObj*> filled_matrix(Vm& vm, std::int64_t rows, std::int64_t cols) {
  if (!possible_size(vm, rows, cols, rows < 0 ? at("r") : at("c"))) return Failed{};
  MatrixObj* A =
      new_matrix_unset(vm, static_cast<std::uint32_t>(rows), static_cast<std::uint32_t>(cols));
  return with_rows(vm, A, [A](std::size_t i, std::size_t first, std::size_t last) {
    std::fill_n(A->data() + i * A->cols + first, last - first, kValue);
  });
}

Answer<MatrixObj*> identity(Vm& vm, std::int64_t size) {
  if (!possible_size(vm, size, size, at("n"))) return Failed{};
  const auto n = static_cast<std::uint32_t>(size);
  MatrixObj* A = new_matrix(vm, n, n);
  // Each row touches a memory page of its own, which is loaded then.
  return with_rows(vm, A,
                   [A, n](std::size_t i, std::size_t, std::size_t) { A->data()[i * n + i] = 1.0; });
}

Answer<MatrixObj*> diagonal_matrix(Vm& vm, std::span<const double> v) {
  const auto n = static_cast<std::int64_t>(v.size());
  if (!possible_size(vm, n, n, at("v"))) return Failed{};
  MatrixObj* A = new_matrix(vm, static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(n));
  return with_rows(vm, A, [A, v](std::size_t i, std::size_t, std::size_t) {
    A->data()[i * v.size() + i] = v[i];
  });
}

ListObj* diagonal_of(Vm& vm, const MatrixObj& A) {
  return numbers_of(
      vm, std::min(A.rows, A.cols),
      [&A](Slot& to, std::size_t i) { to.d = A.data()[i * A.cols + i]; }, kFunctionCost);
}

Answer<MatrixObj*> outer(Vm& vm, std::span<const double> v, std::span<const double> w) {
  if (!possible_size(vm, static_cast<std::int64_t>(v.size()), static_cast<std::int64_t>(w.size()),
                     at("w"))) {
    return Failed{};
  }
  MatrixObj* A = new_matrix_unset(vm, static_cast<std::uint32_t>(v.size()),
                                  static_cast<std::uint32_t>(w.size()));
  double* to = A == nullptr ? nullptr : A->data();
  return with_rows(vm, A, [&](std::size_t i, std::size_t first, std::size_t last) {
    for (const double y : w.subspan(first, last - first)) *to++ = v[i] * y;
  });
}

std::int64_t rows(const MatrixObj& A) { return static_cast<std::int64_t>(A.rows); }
std::int64_t cols(const MatrixObj& A) { return static_cast<std::int64_t>(A.cols); }

MatrixObj* transposed(Vm& vm, const MatrixObj& A) {
  MatrixObj* B = new_matrix_unset(vm, A.cols, A.rows);
  return with_rows(vm, B, [&](std::size_t j, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) B->data()[j * A.rows + i] = A.data()[i * A.cols + j];
  });
}

ListObj* flattened(Vm& vm, const MatrixObj& A) {
  const auto values = elements(A);
  return numbers_of(vm, values.size(), [values](Slot& to, std::size_t i) { to.d = values[i]; });
}

// ---- element by element ------------------------------------------------------------------------

template <class F>
MatrixObj* map_elements(Vm& vm, const MatrixObj& A, F f) {
  MatrixObj* B = new_matrix_unset(vm, A.rows, A.cols);
  return with_rows(vm, B, [&](std::size_t i, std::size_t first, std::size_t last) {
    const double* row = A.data() + i * A.cols;
    std::transform(row + first, row + last, B->data() + i * A.cols + first, f);
  });
}
Answer<void> same_size(Vm& vm, const MatrixObj& A, const MatrixObj& B, std::string_view word) {
  if (A.rows == B.rows && A.cols == B.cols) return {};
  return sizes_differ(
      vm, fmt::format("{} {} {}", size_text(A.rows, A.cols), word, size_text(B.rows, B.cols)),
      CallPart::operand(1), "both matrices need the same size");
}
template <class F>
Answer<MatrixObj*> zip_elements(Vm& vm, const MatrixObj& A, const MatrixObj& B,
                                std::string_view word, F f) {
  if (!same_size(vm, A, B, word)) return Failed{};
  MatrixObj* C = new_matrix_unset(vm, A.rows, A.cols);
  return with_rows(vm, C, [&](std::size_t i, std::size_t first, std::size_t last) {
    const double* a = A.data() + i * A.cols;
    const double* b = B.data() + i * A.cols + first;
    std::transform(a + first, a + last, b, C->data() + i * A.cols + first, f);
  });
}

Answer<MatrixObj*> add(Vm& vm, const MatrixObj& A, const MatrixObj& B) {
  return zip_elements(vm, A, B, "plus", [](double a, double b) { return a + b; });
}
Answer<MatrixObj*> subtract(Vm& vm, const MatrixObj& A, const MatrixObj& B) {
  return zip_elements(vm, A, B, "minus", [](double a, double b) { return a - b; });
}
Answer<MatrixObj*> times_elements(Vm& vm, const MatrixObj& A, const MatrixObj& B) {
  return zip_elements(vm, A, B, ".*", [](double a, double b) { return a * b; });
}
Answer<MatrixObj*> over_elements(Vm& vm, const MatrixObj& A, const MatrixObj& B) {
  return zip_elements(vm, A, B, "./", [](double a, double b) { return a / b; });
}
MatrixObj* matrix_times(Vm& vm, const MatrixObj& A, double k) {
  return map_elements(vm, A, [k](double a) { return a * k; });
}
MatrixObj* times_matrix(Vm& vm, double k, const MatrixObj& A) {
  return map_elements(vm, A, [k](double a) { return k * a; });
}
MatrixObj* matrix_over(Vm& vm, const MatrixObj& A, double k) {
  return map_elements(vm, A, [k](double a) { return a / k; });
}
MatrixObj* negated(Vm& vm, const MatrixObj& A) {
  return map_elements(vm, A, [](double a) { return -a; });
}

// A negative number has no power with a fractional exponent.
template <class Exponent>
Answer<MatrixObj*> raise_elements(Vm& vm, const MatrixObj& A, Exponent exponent) {
  MatrixObj* C = new_matrix_unset(vm, A.rows, A.cols);
  if (C == nullptr) return Failed{};
  std::size_t bad = count_of(A);
  const auto raise = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && bad == count_of(A); ++i) {
      C->data()[i] = det::pow(A.data()[i], exponent(i));
      if (std::isnan(C->data()[i]) && !std::isnan(A.data()[i]) && !std::isnan(exponent(i))) bad = i;
    }
    return bad == count_of(A);
  };
  if (in_blocks(vm, count_of(A), 2 * kFunctionCost, raise)) return C;
  release(vm, C);
  if (bad == count_of(A)) return Failed{};
  return failure(vm, "R0609",
                 fmt::format("element [{}, {}] is {:.15g}, which has no power {:.15g}",
                             bad / A.cols, bad % A.cols, A.data()[bad], exponent(bad)),
                 CallPart::first(), "a negative number has only whole powers");
}
Answer<MatrixObj*> powers_of_elements(Vm& vm, const MatrixObj& A, const MatrixObj& B) {
  if (!same_size(vm, A, B, ".^")) return Failed{};
  return raise_elements(vm, A, [&B](std::size_t i) { return B.data()[i]; });
}
Answer<MatrixObj*> power_of_elements(Vm& vm, const MatrixObj& A, double k) {
  return raise_elements(vm, A, [k](std::size_t) { return k; });
}

// ---- products ----------------------------------------------------------------------------------

// Multiplies a band of rows at a time, so that a long product can be cancelled.
bool multiply_charged(Vm& vm, const MatrixObj& A, const MatrixObj& B, MatrixObj& C) {
  constexpr std::uint64_t kBand = 4'000'000;
  const std::uint64_t per_row = std::uint64_t{A.cols} * B.cols;
  const std::size_t band = std::max<std::uint64_t>(16, kBand / std::max<std::uint64_t>(1, per_row));
  for (std::size_t i = 0; i < A.rows; i += band) {
    const std::size_t count = std::min<std::size_t>(band, A.rows - i);
    if (!charge_work(vm, count * per_row)) return false;
    multiply(A.data() + i * A.cols, B.data(), C.data() + i * C.cols, count, A.cols, B.cols);
  }
  return true;
}

Answer<MatrixObj*> product(Vm& vm, const MatrixObj& A, const MatrixObj& B) {
  if (A.cols != B.rows) {
    return sizes_differ(
        vm, fmt::format("{} times {}", size_text(A.rows, A.cols), size_text(B.rows, B.cols)),
        CallPart::operand(1), "the first matrix needs as many columns as the second has rows");
  }
  if (!possible_size(vm, A.rows, B.cols, {})) return Failed{};
  MatrixObj* C = new_matrix_unset(vm, A.rows, B.cols);
  if (C == nullptr) return Failed{};
  if (multiply_charged(vm, A, B, *C)) return C;
  release(vm, C);
  return Failed{};
}

Answer<ListObj*> product_with(Vm& vm, const MatrixObj& A, std::span<const double> x) {
  if (A.cols != x.size()) {
    return sizes_differ(vm, fmt::format("{} times {}", size_text(A.rows, A.cols), x.size()),
                        CallPart::operand(1),
                        "the matrix needs as many columns as the list has values");
  }
  ListObj* y = new_list(vm, A.rows, false);
  if (y == nullptr) return Failed{};
  auto* to = reinterpret_cast<double*>(y->data);
  const auto multiply_band = [&](std::size_t begin, std::size_t end) {
    multiply_vector(A.data() + begin * A.cols, x.data(), to + begin, end - begin, A.cols);
  };
  if (in_blocks(vm, A.rows, 1 + A.cols, multiply_band)) return y;
  release(vm, y);
  return Failed{};
}
Answer<ListObj*> product_with_joints(Vm& vm, const MatrixObj& A, const PosJ& q) {
  return product_with(vm, A, {q.q.data(), q.n});
}

// ---- comparison --------------------------------------------------------------------------------

Answer<bool> near(Vm& vm, const MatrixObj& A, const MatrixObj& B, double tol) {
  if (A.rows != B.rows || A.cols != B.cols) return false;
  bool is_near = true;
  const auto look = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && is_near; ++i)
      is_near = std::abs(A.data()[i] - B.data()[i]) <= tol;
    return is_near;
  };
  if (!in_blocks(vm, count_of(A), kCost, look) && is_near) return Failed{};
  return is_near;
}

Answer<std::string> explain_near(Vm& vm, const MatrixObj& A, const MatrixObj& B, double) {
  if (A.rows != B.rows || A.cols != B.cols) {
    return fmt::format("the sizes are {} and {}", size_text(A.rows, A.cols),
                       size_text(B.rows, B.cols));
  }
  std::size_t worst = 0;
  double most = -1.0;
  const auto look = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !std::isnan(most); ++i) {
      const double difference = std::abs(A.data()[i] - B.data()[i]);
      if (difference <= most) continue;
      worst = i;
      most = difference;
    }
  };
  if (!in_blocks(vm, count_of(A), kCost, look)) return Failed{};
  return fmt::format("they differ by {:.3g} at [{}, {}]", most, worst / A.cols, worst % A.cols);
}

constexpr NativeFunction kMatrixFunctions[] = {
    def<matrix_from<false>>("matrix(rows: double[][]) -> matrix", "A matrix from a list of rows.",
                            "matrix([[1.0, 2.0], [3.0, 4.0]])"),
    def<matrix_from<true>>("matrix(rows: int[][]) -> matrix", "A matrix from a list of rows.",
                           "matrix([[1, 2], [3, 4]])"),
    def<filled_matrix<0>>("zeros(r: int, c: int) -> matrix", "A matrix of zeros.", "zeros(2, 3)",
                          {.check = check_filled}),
    def<filled_matrix<1>>("ones(r: int, c: int) -> matrix", "A matrix of ones.", "ones(2, 3)",
                          {.check = check_filled}),
    def<identity>("eye(n: int) -> matrix", "The identity matrix.", "eye(3)",
                  {.check = check_identity}),
    def<diagonal_matrix>("diag(v: double[]) -> matrix", "A square matrix with v on its diagonal.",
                         "diag([1.0, 2.0])", {.check = check_diagonal}),
    def<diagonal_of>("diag(A: matrix) -> double[]", "The diagonal of a matrix.",
                     "diag([1, 2; 3, 4])"),
    def<outer>("outer(v: double[], w: double[]) -> matrix", "The products of every pair of values.",
               "outer([1.0, 2.0], [3.0, 4.0])", {.check = check_outer}),
    def<rows>("matrix.rows(A: matrix) -> int", "How many rows there are.", "[1, 2; 3, 4].rows"),
    def<cols>("matrix.cols(A: matrix) -> int", "How many columns there are.", "[1, 2; 3, 4].cols"),
    def<transposed>("matrix.T(A: matrix) -> matrix", "The transpose: rows become columns.",
                    "[1, 2; 3, 4].T", {.check = check_transposed}),
    def<flattened>("flatten(A: matrix) -> double[]", "All values, row by row.",
                   "flatten([1, 2; 3, 4])"),
    def<product>("operator*(A: matrix, B: matrix) -> matrix", "The matrix product.",
                 "[1, 2; 3, 4] * [0, 1; 1, 0]", {.check = check_product}),
    def<product_with>("operator*(A: matrix, v: double[]) -> double[]",
                      "A matrix times a column of values.", "[1, 2; 3, 4] * [5.0, 6.0]",
                      {.check = check_product}),
    def<product_with_joints>("operator*(A: matrix, q: posJ) -> double[]",
                             "A matrix times joint values.", "eye(4) * joints()"),
    def<matrix_times>("operator*(A: matrix, k: double) -> matrix", "Every element times a number.",
                      "[1, 2; 3, 4] * 2.0", {.check = check_same_size}),
    def<times_matrix>("operator*(k: double, A: matrix) -> matrix", "Every element times a number.",
                      "2.0 * [1, 2; 3, 4]", {.check = check_same_size}),
    def<matrix_over>("operator/(A: matrix, k: double) -> matrix",
                     "Every element divided by a number.", "[1, 2; 3, 4] / 2.0",
                     {.check = check_same_size}),
    def<add>("operator+(A: matrix, B: matrix) -> matrix", "Adds element by element.",
             "[1, 2; 3, 4] + eye(2)", {.check = check_sum}),
    def<subtract>("operator-(A: matrix, B: matrix) -> matrix", "Subtracts element by element.",
                  "[1, 2; 3, 4] - eye(2)", {.check = check_sum}),
    def<negated>("operator-(A: matrix) -> matrix", "Every element with the other sign.",
                 "-[1, 2; 3, 4]", {.check = check_same_size}),
    def<times_elements>("operator.*(A: matrix, B: matrix) -> matrix",
                        "Multiplies element by element.", "[1, 2; 3, 4] .* [5, 6; 7, 8]",
                        {.check = check_sum}),
    def<over_elements>("operator./(A: matrix, B: matrix) -> matrix", "Divides element by element.",
                       "[1, 2; 3, 4] ./ [5, 6; 7, 8]", {.check = check_sum}),
    def<powers_of_elements>("operator.^(A: matrix, B: matrix) -> matrix",
                            "Powers element by element.", "[1, 2; 3, 4] .^ [1, 2; 1, 2]",
                            {.check = check_sum}),
    def<power_of_elements>("operator.^(A: matrix, k: double) -> matrix",
                           "Every element to the power k.", "[1, 2; 3, 4] .^ 2.0",
                           {.check = check_same_size}),
    def<near>("near(a: matrix, b: matrix, tol: double) -> bool",
              "Whether two matrices differ by at most tol in every element.",
              "near([1, 2; 3, 4], [1, 2; 3, 4.01], tol: 0.1)",
              {.explain = explained_by<explain_near>}),
};

}  // namespace

std::span<const NativeFunction> matrix_functions() { return kMatrixFunctions; }

}  // namespace armlet::bind
