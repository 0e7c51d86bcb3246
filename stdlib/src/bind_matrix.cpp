// Matrices: making them, and arithmetic (language reference, sections 8 and 19).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/math/det_math.hpp"
#include "armlet/math/matrix_product.hpp"
#include "blocks.hpp"
#include "matrices.hpp"
#include "values.hpp"

namespace armlet::bind {
namespace {

// A new matrix as the result, after fill(i, first, last) for the columns of every row, which may be
// long or many.
template <class F>
Signal give_rows(Vm& vm, Slot* args, MatrixObj& A, F fill) {
  const std::size_t cols = A.cols;
  const auto rows = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) fill(i, std::size_t{0}, cols);
  };
  const auto parts_of_rows = [&] {
    for (std::size_t i = 0; i < A.rows; ++i) {
      const auto part = [&](std::size_t begin, std::size_t end) { fill(i, begin, end); };
      if (!in_blocks(vm, cols, kCost, part)) return false;
    }
    return true;
  };
  const bool long_rows = cols * kCost > kBlockWork;
  const bool done = long_rows ? parts_of_rows() : in_blocks(vm, A.rows, 16 + kCost * A.cols, rows);
  if (done) return give(args, &A);
  release(vm, &A);
  return Signal::kFail;
}

// ---- making ------------------------------------------------------------------------------------

template <bool kInts>
Signal matrix_from(Vm& vm, Slot* args) {
  const auto rows = items_value(args[0]);
  const std::size_t cols = rows.empty() ? 0 : items_value(rows[0]).size();
  const auto is_even = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t count = items_value(rows[i]).size();
      if (count == cols) continue;
      (void)sizes_differ(
          vm,
          fmt::format("row 0 has {}, row {} has {}", values_text(static_cast<std::int64_t>(cols)),
                      i, values_text(static_cast<std::int64_t>(count))),
          0);
      return false;
    }
    return true;
  };
  if (!in_blocks(vm, rows.size(), 8, is_even)) return Signal::kFail;
  if (!possible_size(vm, static_cast<std::int64_t>(rows.size()), static_cast<std::int64_t>(cols),
                     0)) {
    return Signal::kFail;
  }
  MatrixObj* A = new_matrix_unset(vm, static_cast<std::uint32_t>(rows.size()),
                                  static_cast<std::uint32_t>(cols));
  if (A == nullptr) return Signal::kFail;
  double* to = A->data();
  return give_rows(vm, args, *A, [&](std::size_t i, std::size_t first, std::size_t last) {
    for (const Slot x : items_value(rows[i]).subspan(first, last - first))
      *to++ = kInts ? static_cast<double>(x.i) : x.d;
  });
}

template <int kValue>
Signal filled(Vm& vm, Slot* args) {
  const std::int64_t rows = args[0].i;
  const std::int64_t cols = args[1].i;
  if (!possible_size(vm, rows, cols, rows < 0 ? 0 : 1)) return Signal::kFail;
  MatrixObj* A =
      new_matrix_unset(vm, static_cast<std::uint32_t>(rows), static_cast<std::uint32_t>(cols));
  if (A == nullptr) return Signal::kFail;
  return give_rows(vm, args, *A, [A](std::size_t i, std::size_t first, std::size_t last) {
    std::fill_n(A->data() + i * A->cols + first, last - first, kValue);
  });
}

Signal identity(Vm& vm, Slot* args) {
  if (!possible_size(vm, args[0].i, args[0].i, 0)) return Signal::kFail;
  const auto n = static_cast<std::uint32_t>(args[0].i);
  MatrixObj* A = new_matrix(vm, n, n);
  if (A == nullptr) return Signal::kFail;
  // Each touches a page of its own, which is fetched then.
  return give_rows(vm, args, *A,
                   [A, n](std::size_t i, std::size_t, std::size_t) { A->data()[i * n + i] = 1.0; });
}

Signal diagonal_matrix(Vm& vm, Slot* args) {
  const auto v = reals_value(args[0]);
  const auto n = static_cast<std::int64_t>(v.size());
  if (!possible_size(vm, n, n, 0)) return Signal::kFail;
  MatrixObj* A = new_matrix(vm, static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(n));
  if (A == nullptr) return Signal::kFail;
  return give_rows(vm, args, *A, [A, v](std::size_t i, std::size_t, std::size_t) {
    A->data()[i * v.size() + i] = v[i];
  });
}

Answer<Obj*> diagonal_of(Vm& vm, const MatrixObj& A) {
  ListObj* list = new_list(vm, std::min(A.rows, A.cols), false);
  if (list == nullptr) return Failed{};
  const auto fill = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) list->data[i].d = A.data()[i * A.cols + i];
  };
  if (in_blocks(vm, list->size, kFunctionCost, fill)) return list;
  release(vm, list);
  return Failed{};
}

Signal outer(Vm& vm, Slot* args) {
  const auto v = reals_value(args[0]);
  const auto w = reals_value(args[1]);
  if (!possible_size(vm, static_cast<std::int64_t>(v.size()), static_cast<std::int64_t>(w.size()),
                     1)) {
    return Signal::kFail;
  }
  MatrixObj* A = new_matrix_unset(vm, static_cast<std::uint32_t>(v.size()),
                                  static_cast<std::uint32_t>(w.size()));
  if (A == nullptr) return Signal::kFail;
  double* to = A->data();
  return give_rows(vm, args, *A, [&](std::size_t i, std::size_t first, std::size_t last) {
    for (const double y : w.subspan(first, last - first)) *to++ = v[i] * y;
  });
}

std::int64_t rows(const MatrixObj& _a) { return static_cast<std::int64_t>(_a.rows); }
std::int64_t cols(const MatrixObj& _a) { return static_cast<std::int64_t>(_a.cols); }

Signal transposed(Vm& vm, Slot* args) {
  const MatrixObj& A = matrix_value(args[0]);
  MatrixObj* B = new_matrix_unset(vm, A.cols, A.rows);
  if (B == nullptr) return Signal::kFail;
  return give_rows(vm, args, *B, [&](std::size_t j, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) B->data()[j * A.rows + i] = A.data()[i * A.cols + j];
  });
}

Obj* flattened(Vm& vm, const MatrixObj& _a) {
  const auto values = elements(_a);
  return numbers_of(vm, values.size(), [values](Slot& to, std::size_t i) { to.d = values[i]; });
}

// ---- element by element ------------------------------------------------------------------------

template <class F>
Signal map_elements(Vm& vm, Slot* args, const MatrixObj& A, F f) {
  MatrixObj* B = new_matrix_unset(vm, A.rows, A.cols);
  if (B == nullptr) return Signal::kFail;
  return give_rows(vm, args, *B, [&](std::size_t i, std::size_t first, std::size_t last) {
    const double* row = A.data() + i * A.cols;
    std::transform(row + first, row + last, B->data() + i * A.cols + first, f);
  });
}
bool same_size(Vm& vm, const Slot* args, std::string_view word) {
  const MatrixObj& A = matrix_value(args[0]);
  const MatrixObj& B = matrix_value(args[1]);
  if (A.rows == B.rows && A.cols == B.cols) return true;
  (void)sizes_differ(
      vm, fmt::format("{} {} {}", size_text(A.rows, A.cols), word, size_text(B.rows, B.cols)), 1,
      "both matrices need the same size");
  return false;
}
template <class F>
Signal zip_elements(Vm& vm, Slot* args, std::string_view word, F f) {
  if (!same_size(vm, args, word)) return Signal::kFail;
  const MatrixObj& A = matrix_value(args[0]);
  MatrixObj* C = new_matrix_unset(vm, A.rows, A.cols);
  if (C == nullptr) return Signal::kFail;
  return give_rows(vm, args, *C, [&](std::size_t i, std::size_t first, std::size_t last) {
    const double* a = A.data() + i * A.cols;
    const double* b = matrix_value(args[1]).data() + i * A.cols + first;
    std::transform(a + first, a + last, b, C->data() + i * A.cols + first, f);
  });
}

Signal add(Vm& vm, Slot* args) {
  return zip_elements(vm, args, "plus", [](double a, double b) { return a + b; });
}
Signal subtract(Vm& vm, Slot* args) {
  return zip_elements(vm, args, "minus", [](double a, double b) { return a - b; });
}
Signal times_elements(Vm& vm, Slot* args) {
  return zip_elements(vm, args, ".*", [](double a, double b) { return a * b; });
}
Signal over_elements(Vm& vm, Slot* args) {
  return zip_elements(vm, args, "./", [](double a, double b) { return a / b; });
}
Signal matrix_times(Vm& vm, Slot* args) {
  const double k = args[1].d;
  return map_elements(vm, args, matrix_value(args[0]), [k](double a) { return a * k; });
}
Signal times_matrix(Vm& vm, Slot* args) {
  const double k = args[0].d;
  return map_elements(vm, args, matrix_value(args[1]), [k](double a) { return k * a; });
}
Signal matrix_over(Vm& vm, Slot* args) {
  const double k = args[1].d;
  return map_elements(vm, args, matrix_value(args[0]), [k](double a) { return a / k; });
}
Signal negated(Vm& vm, Slot* args) {
  return map_elements(vm, args, matrix_value(args[0]), [](double a) { return -a; });
}

// A negative number with a fraction above it has no power.
template <class Exponent>
Signal raise_elements(Vm& vm, Slot* args, const MatrixObj& A, Exponent exponent) {
  MatrixObj* C = new_matrix_unset(vm, A.rows, A.cols);
  if (C == nullptr) return Signal::kFail;
  const auto raise = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double a = A.data()[i];
      const double k = exponent(i);
      C->data()[i] = det::pow(a, k);
      if (!std::isnan(C->data()[i]) || std::isnan(a) || std::isnan(k)) continue;
      (void)failure(vm, "R0609",
                    fmt::format("element [{}, {}] is {:.15g}, which has no power {:.15g}",
                                i / A.cols, i % A.cols, a, k),
                    0, "a negative number has only whole powers");
      return false;
    }
    return true;
  };
  if (in_blocks(vm, count_of(A), 2 * kFunctionCost, raise)) return give(args, C);
  release(vm, C);
  return Signal::kFail;
}
Signal powers_of_elements(Vm& vm, Slot* args) {
  const MatrixObj& B = matrix_value(args[1]);
  if (!same_size(vm, args, ".^")) return Signal::kFail;
  return raise_elements(vm, args, matrix_value(args[0]),
                        [&B](std::size_t i) { return B.data()[i]; });
}
Signal power_of_elements(Vm& vm, Slot* args) {
  const double k = args[1].d;
  return raise_elements(vm, args, matrix_value(args[0]), [k](std::size_t) { return k; });
}

// ---- products ----------------------------------------------------------------------------------

// A band of rows at a time, so that a long product can be cancelled.
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

Answer<Obj*> product(Vm& vm, const MatrixObj& A, const MatrixObj& B) {
  if (A.cols != B.rows) {
    return sizes_differ(
        vm, fmt::format("{} times {}", size_text(A.rows, A.cols), size_text(B.rows, B.cols)), 1,
        "the first matrix needs as many columns as the second has rows");
  }
  if (!possible_size(vm, A.rows, B.cols, -1)) return Failed{};
  MatrixObj* C = new_matrix_unset(vm, A.rows, B.cols);
  if (C == nullptr) return Failed{};
  if (multiply_charged(vm, A, B, *C)) return C;
  release(vm, C);
  return Failed{};
}

Signal product_with(Vm& vm, Slot* args, std::span<const double> x) {
  const MatrixObj& A = matrix_value(args[0]);
  if (A.cols != x.size()) {
    return sizes_differ(vm, fmt::format("{} times {}", size_text(A.rows, A.cols), x.size()), 1,
                        "the matrix needs as many columns as the list has values");
  }
  ListObj* y = new_list(vm, A.rows, false);
  if (y == nullptr) return Signal::kFail;
  auto* to = reinterpret_cast<double*>(y->data);
  const auto multiply_band = [&](std::size_t begin, std::size_t end) {
    multiply_vector(A.data() + begin * A.cols, x.data(), to + begin, end - begin, A.cols);
  };
  if (in_blocks(vm, A.rows, 1 + A.cols, multiply_band)) return give(args, y);
  release(vm, y);
  return Signal::kFail;
}
Signal product_with_list(Vm& vm, Slot* args) {
  return product_with(vm, args, reals_value(args[1]));
}
Signal product_with_joints(Vm& vm, Slot* args) {
  const PosJ& q = posj(args[1]);
  return product_with(vm, args, {q.q.data(), q.n});
}

// ---- comparing ---------------------------------------------------------------------------------

Answer<bool> near(Vm& vm, const MatrixObj& A, const MatrixObj& B, double tol) {
  if (A.rows != B.rows || A.cols != B.cols) return false;
  bool is_near = true;
  const auto look = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && is_near; ++i)
      is_near = std::abs(A.data()[i] - B.data()[i]) <= tol;
    return is_near;
  };
  const bool seen = in_blocks(vm, count_of(A), kCost, look) || !is_near;
  if (!(seen)) return Failed{};
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
    {"matrix", "(rows: double[][]) -> matrix", "A matrix from a list of rows.",
     "matrix([[1.0, 2.0], [3.0, 4.0]])", matrix_from<false>},
    {"matrix", "(rows: int[][]) -> matrix", "A matrix from a list of rows.",
     "matrix([[1, 2], [3, 4]])", matrix_from<true>},
    {"zeros", "(r: int, c: int) -> matrix", "A matrix of zeros.", "zeros(2, 3)", filled<0>, nullptr,
     nullptr, check_filled},
    {"ones", "(r: int, c: int) -> matrix", "A matrix of ones.", "ones(2, 3)", filled<1>, nullptr,
     nullptr, check_filled},
    {"eye", "(n: int) -> matrix", "The identity matrix.", "eye(3)", identity, nullptr, nullptr,
     check_identity},
    {"diag", "(v: double[]) -> matrix", "A square matrix with v on its diagonal.",
     "diag([1.0, 2.0])", diagonal_matrix, nullptr, nullptr, check_diagonal},
    def<diagonal_of>("diag(A: matrix) -> double[]", "The diagonal of a matrix.",
                     "diag([1, 2; 3, 4])"),
    {"outer", "(v: double[], w: double[]) -> matrix", "The products of every pair of values.",
     "outer([1.0, 2.0], [3.0, 4.0])", outer, nullptr, nullptr, check_outer},
    def<rows>("matrix.rows(A: matrix) -> int", "How many rows there are.", "[1, 2; 3, 4].rows"),
    def<cols>("matrix.cols(A: matrix) -> int", "How many columns there are.", "[1, 2; 3, 4].cols"),
    {"matrix.T", "(A: matrix) -> matrix", "The transpose: rows become columns.", "[1, 2; 3, 4].T",
     transposed, nullptr, nullptr, check_transposed},
    def<flattened>("flatten(A: matrix) -> double[]", "All values, row by row.",
                   "flatten([1, 2; 3, 4])"),
    def<product>("operator*(A: matrix, B: matrix) -> matrix", "The matrix product.",
                 "[1, 2; 3, 4] * [0, 1; 1, 0]", {.check = check_product}),
    {"operator*", "(A: matrix, v: double[]) -> double[]", "A matrix times a column of values.",
     "[1, 2; 3, 4] * [5.0, 6.0]", product_with_list, nullptr, nullptr, check_product},
    {"operator*", "(A: matrix, q: posJ) -> double[]", "A matrix times joint values.",
     "eye(4) * joints()", product_with_joints},
    {"operator*", "(A: matrix, k: double) -> matrix", "Every element times a number.",
     "[1, 2; 3, 4] * 2.0", matrix_times, nullptr, nullptr, check_same_size},
    {"operator*", "(k: double, A: matrix) -> matrix", "Every element times a number.",
     "2.0 * [1, 2; 3, 4]", times_matrix, nullptr, nullptr, check_same_size},
    {"operator/", "(A: matrix, k: double) -> matrix", "Every element divided by a number.",
     "[1, 2; 3, 4] / 2.0", matrix_over, nullptr, nullptr, check_same_size},
    {"operator+", "(A: matrix, B: matrix) -> matrix", "Adds element by element.",
     "[1, 2; 3, 4] + eye(2)", add, nullptr, nullptr, check_sum},
    {"operator-", "(A: matrix, B: matrix) -> matrix", "Subtracts element by element.",
     "[1, 2; 3, 4] - eye(2)", subtract, nullptr, nullptr, check_sum},
    {"operator-", "(A: matrix) -> matrix", "Every element with the other sign.", "-[1, 2; 3, 4]",
     negated, nullptr, nullptr, check_same_size},
    {"operator.*", "(A: matrix, B: matrix) -> matrix", "Multiplies element by element.",
     "[1, 2; 3, 4] .* [5, 6; 7, 8]", times_elements, nullptr, nullptr, check_sum},
    {"operator./", "(A: matrix, B: matrix) -> matrix", "Divides element by element.",
     "[1, 2; 3, 4] ./ [5, 6; 7, 8]", over_elements, nullptr, nullptr, check_sum},
    {"operator.^", "(A: matrix, B: matrix) -> matrix", "Powers element by element.",
     "[1, 2; 3, 4] .^ [1, 2; 1, 2]", powers_of_elements, nullptr, nullptr, check_sum},
    {"operator.^", "(A: matrix, k: double) -> matrix", "Every element to the power k.",
     "[1, 2; 3, 4] .^ 2.0", power_of_elements, nullptr, nullptr, check_same_size},
    def<near>("near(a: matrix, b: matrix, tol: double) -> bool",
              "Whether two matrices differ by at most tol in every element.",
              "near([1, 2; 3, 4], [1, 2; 3, 4.01], tol: 0.1)",
              {.explain = explained_by<explain_near>}),
};

}  // namespace

std::span<const NativeFunction> matrix_functions() { return kMatrixFunctions; }

}  // namespace armlet::bind
