// Linear algebra: equations, decompositions, functions of matrices (language reference, section
// 19).

#include <fmt/format.h>

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "armlet/interpreter/engine.hpp"
#include "armlet/math/decompose.hpp"
#include "armlet/math/linalg.hpp"
#include "armlet/math/matrix_product.hpp"
#include "messages/library_messages.hpp"
#include "rules/matrix_rules.hpp"
#include "values/blocks.hpp"
#include "values/matrices.hpp"

namespace armlet::bind {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

MatrixXd to_eigen(const MatrixObj& A) {
  return Eigen::Map<const RowMatrix>(A.data(), A.rows, A.cols);
}
Obj* to_matrix(Vm& vm, const MatrixXd& A) {
  MatrixObj* out = new_matrix_unset(vm, static_cast<std::uint32_t>(A.rows()),
                                    static_cast<std::uint32_t>(A.cols()));
  if (out != nullptr) Eigen::Map<RowMatrix>(out->data(), A.rows(), A.cols()) = A;
  return out;
}
Obj* to_list(Vm& vm, const VectorXd& v) {
  return new_reals(vm, {v.data(), static_cast<std::size_t>(v.size())});
}

// ---- checks and results ------------------------------------------------------------------------

// The requirements of a function on its matrix, and its cost in units of n^3 operations and in
// copies.
struct Task {
  std::string_view name;
  bool square = false;
  unsigned work = 1;
  unsigned copies = 3;
};

Answer<void> require_finite(Vm& vm, const MatrixObj& A, CallPart part) {
  std::size_t bad = count_of(A);
  if (!find_number(vm, elements(A), bad, [](double x) { return !std::isfinite(x); }))
    return Failed{};
  if (bad == count_of(A)) return {};
  return not_finite(vm, fmt::format("element [{}, {}] of the matrix", bad / A.cols, bad % A.cols),
                    A.data()[bad], part);
}

Answer<void> make_ready(Vm& vm, const MatrixObj& A, const Task& task) {
  if (task.square && A.rows != A.cols) return not_square(vm, task.name, A);
  if (std::max(A.rows, A.cols) > kMostDecomposed) {
    return failure(vm, "R0613",
                   fmt::format("{} of a {} matrix: at most {} rows and columns are possible",
                               task.name, size_text(A.rows, A.cols), kMostDecomposed),
                   CallPart::first());
  }
  if (!require_finite(vm, A, CallPart::first()) ||
      !charge_work(vm, std::uint64_t{task.work} * count_of(A) * std::min(A.rows, A.cols))) {
    return Failed{};
  }
  return {};
}

// The Answer of f(matrix), after the checks of the task.
template <class F>
auto on_matrix(Vm& vm, const MatrixObj& A, const Task& task, F f) -> decltype(f(MatrixXd())) {
  if (!make_ready(vm, A, task)) return Failed{};
  const std::uint64_t longest = std::max(A.rows, A.cols);
  const Scratch scratch(vm, std::uint64_t{task.copies} * longest * longest * sizeof(double));
  if (!scratch.granted()) return Failed{};
  return f(to_eigen(A));
}

// The failure for a problem without an answer, in the words of the catalogue.
Failed no_answer(Vm& vm, std::string_view name, const Error& error) {
  if (error.code == "singular") {
    Failure f;
    f.headline = {row("R0616"), {"the matrix"}};
    f.mark = CallPart::first();
    f.why = error.message;
    f.fix = name == "solving"
                ? "multiply by pinv({arg}) to get the smallest of the nearest solutions"
                : "pinv({arg}) exists for every matrix";
    return fail(vm, std::move(f));
  }
  if (error.code == "complex") {
    return failure(vm, "R0609", fmt::format("{} needs real eigenvalues", name), CallPart::first(),
                   error.message, "eigenvalues({arg}) gives their real and imaginary parts");
  }
  if (error.code == "not_symmetric")
    return failure(vm, "R0609", fmt::format("{} needs a symmetric matrix", name),
                   CallPart::first());
  if (error.code == "not_positive")
    return failure(vm, "R0609", fmt::format("{} needs a positive definite matrix", name),
                   CallPart::first(), error.message);
  return failure(vm, "R0610", fmt::format("{}: {}", name, error.message), CallPart::first());
}

Answer<Obj*> matrix_or_why(Vm& vm, std::string_view name, const Result<MatrixXd>& result) {
  if (!result) return no_answer(vm, name, result.error());
  return to_matrix(vm, *result);
}

// A record of the library from its parts; null if a part could not be made (its failure is set).
template <std::size_t kParts>
Answer<Obj*> record_of(Vm& vm, std::string_view type, const std::array<Obj*, kParts>& parts) {
  bool whole = true;
  for (const Obj* part : parts) whole = whole && part != nullptr;
  RecordObj* record = whole ? new_record(vm, vm.program().library_record(type)) : nullptr;
  for (std::size_t i = 0; i < kParts; ++i) {
    if (record != nullptr) {
      record->fields()[i].o = parts[i];
    } else if (parts[i] != nullptr) {
      release(vm, parts[i]);
    }
  }
  return record;
}

// ---- equations ---------------------------------------------------------------------------------

Answer<Obj*> solve_matrix(Vm& vm, const MatrixObj& A, const MatrixObj& B) {
  if (A.rows != B.rows) {
    return sizes_differ(
        vm, fmt::format("{} \\ {}", size_text(A.rows, A.cols), size_text(B.rows, B.cols)), at("B"),
        "both matrices need equally many rows");
  }
  if (!require_finite(vm, B, at("B")) || !charge_work(vm, count_of(B) * A.cols)) return Failed{};
  return on_matrix(vm, A, {.name = "solving", .work = 2, .copies = 4}, [&](const MatrixXd& a) {
    return matrix_or_why(vm, "solving", solve(a, to_eigen(B)));
  });
}

Answer<Obj*> solve_list(Vm& vm, const MatrixObj& A, std::span<const double> b) {
  if (A.rows != b.size()) {
    return sizes_differ(vm, fmt::format("{} \\ {}", size_text(A.rows, A.cols), b.size()), at("b"),
                        "the matrix needs as many rows as the list has values");
  }
  std::size_t bad = b.size();
  if (!find_number(vm, b, bad, [](double x) { return !std::isfinite(x); })) return Failed{};
  if (bad != b.size())
    return not_finite(vm, fmt::format("element {} of the list", bad), b[bad], at("b"));
  const auto solved = [&](const MatrixXd& a) -> Answer<Obj*> {
    const auto x =
        solve(a, Eigen::Map<const VectorXd>(b.data(), static_cast<Eigen::Index>(b.size())));
    if (!x) return no_answer(vm, "solving", x.error());
    return to_list(vm, x->col(0));
  };
  return on_matrix(vm, A, {.name = "solving", .work = 2, .copies = 4}, solved);
}

Answer<Obj*> inverse_of(Vm& vm, const MatrixObj& M) {
  return on_matrix(vm, M, {.name = "inv", .square = true, .work = 3},
                   [&](const MatrixXd& A) { return matrix_or_why(vm, "inv", inverse(A)); });
}

// Makes a matrix; fails unless all its numbers are finite.
Answer<Obj*> finite_matrix(Vm& vm, std::string_view name, const MatrixXd& A) {
  if (A.allFinite()) return to_matrix(vm, A);
  return no_answer(vm, name, {"overflow", "the numbers of the result are too large for a double"});
}

Answer<Obj*> pseudo_inverse(Vm& vm, const MatrixObj& M) {
  return on_matrix(vm, M, {.name = "pinv", .work = 25, .copies = 6}, [&](const MatrixXd& A) {
    return finite_matrix(vm, "pinv", damped_pseudo_inverse(A));
  });
}

// ---- numbers -----------------------------------------------------------------------------------

Answer<double> determinant_of(Vm& vm, const MatrixObj& M) {
  const auto found = [&](const MatrixXd& A) -> Answer<double> {
    const auto det = determinant(A);
    if (!det) return no_answer(vm, "det", det.error());
    return *det;
  };
  return on_matrix(vm, M, {.name = "det", .square = true}, found);
}

Answer<std::int64_t> rank_of(Vm& vm, const MatrixObj& M) {
  return on_matrix(vm, M, {.name = "rank", .work = 20, .copies = 6}, [](const MatrixXd& A) {
    return Answer<std::int64_t>(static_cast<std::int64_t>(rank(A)));
  });
}

Answer<double> trace_of(Vm& vm, const MatrixObj& A) {
  if (A.rows != A.cols) return not_square(vm, "trace", A);
  double sum = 0.0;
  const auto add = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) sum += A.data()[i * A.cols + i];
  };
  if (!in_blocks(vm, A.rows, kFunctionCost, add)) return Failed{};
  return sum;
}

// ---- decompositions ----------------------------------------------------------------------------

Answer<Obj*> lu_of(Vm& vm, const MatrixObj& M) {
  return on_matrix(vm, M, {.name = "lu", .square = true, .copies = 5}, [&](const MatrixXd& A) {
    const LuParts parts = lu_decomposition(A);
    return record_of<3>(vm, "Lu",
                        {to_matrix(vm, parts.L), to_matrix(vm, parts.U), to_matrix(vm, parts.P)});
  });
}

Answer<Obj*> qr_of(Vm& vm, const MatrixObj& M) {
  return on_matrix(vm, M, {.name = "qr", .work = 3, .copies = 4}, [&](const MatrixXd& A) {
    const QrParts parts = qr_decomposition(A);
    return record_of<2>(vm, "Qr", {to_matrix(vm, parts.Q), to_matrix(vm, parts.R)});
  });
}

Answer<Obj*> cholesky_of(Vm& vm, const MatrixObj& M) {
  return on_matrix(vm, M, {.name = "chol", .square = true},
                   [&](const MatrixXd& A) { return matrix_or_why(vm, "chol", cholesky(A)); });
}

Answer<Obj*> svd_of(Vm& vm, const MatrixObj& M) {
  return on_matrix(vm, M, {.name = "svd", .work = 20, .copies = 8}, [&](const MatrixXd& A) {
    const SvdParts parts = singular_values(A);
    return record_of<3>(vm, "Svd",
                        {to_matrix(vm, parts.U), to_list(vm, parts.s), to_matrix(vm, parts.V)});
  });
}

// A record of the result of `decompose`, its two fields made by `fields`; a failure if the
// decomposition does not exist.
template <class Decompose, class Fields>
auto into_record(Vm& vm, const Task& task, std::string_view record, const Decompose& decompose,
                 const Fields& fields) {
  return [&vm, &task, record, &decompose, &fields](const MatrixXd& A) -> Answer<Obj*> {
    const auto parts = decompose(A);
    if (!parts) return no_answer(vm, task.name, parts.error());
    return record_of<2>(vm, record, fields(*parts));
  };
}

Answer<Obj*> eigenvectors_of(Vm& vm, const MatrixObj& M) {
  const Task task{.name = "eig", .square = true, .work = 25, .copies = 6};
  const auto fields = [&](const auto& parts) {
    return std::array{to_list(vm, parts.values), to_matrix(vm, parts.vectors)};
  };
  return on_matrix(vm, M, task, into_record(vm, task, "Eig", eigenvectors, fields));
}

Answer<Obj*> eigenvalues_of(Vm& vm, const MatrixObj& M) {
  const Task task{.name = "eigenvalues", .square = true, .work = 20, .copies = 5};
  const auto fields = [&](const auto& parts) {
    return std::array{to_list(vm, parts.re), to_list(vm, parts.im)};
  };
  return on_matrix(vm, M, task, into_record(vm, task, "Eigenvalues", eigenvalues, fields));
}

// ---- powers ------------------------------------------------------------------------------------

Answer<Obj*> exponential_of(Vm& vm, const MatrixObj& M) {
  const Task task{.name = "expm", .square = true, .work = 25, .copies = 8};
  return on_matrix(vm, M, task,
                   [&](const MatrixXd& A) { return matrix_or_why(vm, "expm", exponential(A)); });
}

// The power by repeated squaring. n: not negative.
bool raise(Vm& vm, RowMatrix A, std::uint64_t n, RowMatrix& power) {
  const auto size = static_cast<std::size_t>(A.rows());
  RowMatrix product(A.rows(), A.cols());
  const auto times = [&](RowMatrix& left, const RowMatrix& right) {
    if (!charge_work(vm, std::uint64_t{size} * size * size)) return false;
    multiply(left.data(), right.data(), product.data(), size, size, size);
    left.swap(product);
    return true;
  };
  power = RowMatrix::Identity(A.rows(), A.cols());
  for (; n > 0; n /= 2) {
    if (n % 2 != 0 && !times(power, A)) return false;
    if (n > 1 && !times(A, RowMatrix(A))) return false;
  }
  return true;
}

Answer<Obj*> power_of(Vm& vm, const MatrixObj& M, std::int64_t n) {
  const Task task{.name = "a power", .square = true, .work = n < 0 ? 3U : 1U, .copies = 5};
  return on_matrix(vm, M, task, [&](const MatrixXd& A) -> Answer<Obj*> {
    const Result<MatrixXd> base = n < 0 ? inverse(A) : Result<MatrixXd>(A);
    if (!base) return no_answer(vm, "a power", base.error());
    const std::uint64_t times =
        n < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(n) : static_cast<std::uint64_t>(n);
    RowMatrix power;
    if (!raise(vm, *base, times, power)) return Failed{};
    return finite_matrix(vm, "a power", power);
  });
}

constexpr NativeFunction kLinalgFunctions[] = {
    def<solve_list>(
        "operator\\(A: matrix, b: double[]) -> double[]",
        "Solves A x = b: by LU for a square matrix, otherwise least squares by QR; with fewer rows "
        "than columns the smallest solution.",
        "[2, 1; 1, 3] \\ [3.0, 5.0]", {.check = check_solve}),
    def<solve_matrix>("operator\\(A: matrix, B: matrix) -> matrix",
                      "Solves A X = B for every column of B.", "[2, 1; 1, 3] \\ eye(2)",
                      {.check = check_solve}),
    def<power_of>("operator^(A: matrix, n: int) -> matrix",
                  "The matrix times itself; with a negative n, the inverse times itself.",
                  "[1, 1; 1, 0] ^ 10", {.check = check_square}),
    def<inverse_of>("inv(A: matrix) -> matrix",
                    "The inverse. To solve equations, A \\ b is better.", "inv([2, 1; 1, 3])",
                    {.check = check_square}),
    def<pseudo_inverse>(
        "pinv(A: matrix) -> matrix",
        "The pseudo-inverse; singular values below 1e-12 of the largest count as 0.",
        "pinv([1, 2; 3, 4; 5, 6])", {.check = check_transposed}),
    def<determinant_of>("det(A: matrix) -> double", "The determinant.", "det([1, 2; 3, 4])",
                        {.check = check_square_to_number}),
    def<rank_of>(
        "rank(A: matrix) -> int",
        "How many rows are independent: singular values above the rounding of the largest.",
        "rank([1, 2; 2, 4])"),
    def<trace_of>("trace(A: matrix) -> double", "The sum of the diagonal.", "trace([1, 2; 3, 4])",
                  {.check = check_square_to_number}),
    def<lu_of>(
        "lu(A: matrix) -> Lu",
        "P * A = L * U: P exchanges rows, L has ones on its diagonal, U is upper triangular.",
        "lu([1, 2; 3, 4]).U", {.check = check_square_to_number}),
    def<qr_of>(
        "qr(A: matrix) -> Qr",
        "A = Q * R: columns of Q orthonormal, R upper triangular with no negative number on its "
        "diagonal.",
        "qr([1, 2; 3, 4; 5, 6]).R"),
    def<cholesky_of>(
        "chol(A: matrix) -> matrix",
        "The lower triangular L with L * L.T = A, for a symmetric positive definite A.",
        "chol([4, 2; 2, 3])", {.check = check_square}),
    def<svd_of>("svd(A: matrix) -> Svd",
                "A = U * diag(s) * V.T: columns of U and V orthonormal, s in descending order.",
                "svd([1, 2; 3, 4]).s"),
    def<eigenvectors_of>(
        "eig(A: matrix) -> Eig",
        "Real eigenvalues in ascending order, and an eigenvector of length 1 in each column. Other "
        "matrices have eigenvalues(A).",
        "eig([2, 1; 1, 2]).values", {.check = check_square_to_number}),
    def<eigenvalues_of>("eigenvalues(A: matrix) -> Eigenvalues",
                        "Real and imaginary parts of all eigenvalues, in ascending order.",
                        "eigenvalues([0, -1; 1, 0]).im", {.check = check_square_to_number}),
    def<exponential_of>("expm(A: matrix) -> matrix",
                        "e to the power of a matrix: the sum of A^n / n!.", "expm([0, -1; 1, 0])",
                        {.check = check_square}),
};

}  // namespace

std::span<const NativeFunction> linalg_functions() { return kLinalgFunctions; }

}  // namespace armlet::bind
