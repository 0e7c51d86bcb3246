#include "armlet/math/decompose.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>

#include "armlet/core/random.hpp"
#include "matrices.hpp"

using namespace armlet;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

Index random_size(Random& random) { return 1 + static_cast<Index>(random.below(8)); }

// Random elements, but far enough from singular for tolerances of some thousand roundings.
MatrixXd random_regular(Random& random, Index n) {
  return random_matrix(random, n, n) + 2.0 * MatrixXd::Identity(n, n) * std::sqrt(n);
}

double distance(const MatrixXd& A, const MatrixXd& B) {
  return A.size() == 0 ? 0.0 : (A - B).cwiseAbs().maxCoeff();
}

MatrixXd identity(Index n) { return MatrixXd::Identity(n, n); }

constexpr double kTight = 1e-12;  // a few thousand roundings of numbers near 1

}  // namespace

TEST_CASE("a solution solves, and the inverse is one from both sides") {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Index n = random_size(random);
    const MatrixXd A = random_regular(random, n);
    const MatrixXd B = random_matrix(random, n, random_size(random));
    CHECK(distance(A * solve(A, B).value(), B) < kTight);
    const MatrixXd inv = inverse(A).value();
    CHECK(distance(A * inv, identity(n)) < kTight);
    CHECK(distance(inv * A, identity(n)) < kTight);
  }
}

TEST_CASE("least squares leave a rest that is square to every column") {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Index cols = random_size(random);
    const Index rows = cols + random_size(random);
    MatrixXd A = random_matrix(random, rows, cols);
    A.topRows(cols) += 3.0 * identity(cols);
    const VectorXd b = random_matrix(random, rows, 1);
    const VectorXd x = solve(A, b).value();
    CHECK((A.transpose() * (A * x - b)).cwiseAbs().maxCoeff() < kTight);
  }
}

TEST_CASE("with too few equations the smallest solution is found") {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Index rows = random_size(random);
    const Index cols = rows + random_size(random);
    MatrixXd A = random_matrix(random, rows, cols);
    A.leftCols(rows) += 3.0 * identity(rows);
    const VectorXd b = random_matrix(random, rows, 1);
    const VectorXd x = solve(A, b).value();
    CHECK((A * x - b).cwiseAbs().maxCoeff() < kTight);
    // The smallest is a combination of rows.
    const VectorXd y = solve(A.transpose(), x).value();
    CHECK((A.transpose() * y - x).cwiseAbs().maxCoeff() < kTight);
  }
}

TEST_CASE("LU reproduces the matrix with exchanged rows, by pivots that are the largest") {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Index n = random_size(random);
    const MatrixXd A = random_matrix(random, n, n);
    const LuParts lu = lu_decomposition(A);
    CHECK(distance(lu.P * A, lu.L * lu.U) < kTight);
    CHECK(lu.L.isLowerTriangular(0.0));
    CHECK(lu.U.isUpperTriangular(0.0));
    CHECK(lu.L.diagonal() == VectorXd::Ones(n));
    CHECK(lu.L.cwiseAbs().maxCoeff() <= 1.0);
    CHECK(lu.P * lu.P.transpose() == identity(n));
  }
}

TEST_CASE("LU gives the factors of Golub and Van Loan's example (1996, section 3.4)") {
  const MatrixXd A{{3, 17, 10}, {2, 4, -2}, {6, 18, -12}};
  const LuParts lu = lu_decomposition(A);
  CHECK(distance(lu.L, MatrixXd{{1, 0, 0}, {0.5, 1, 0}, {1 / 3.0, -0.25, 1}}) < 1e-15);
  CHECK(distance(lu.U, MatrixXd{{6, 18, -12}, {0, 8, 16}, {0, 0, 6}}) < 1e-14);
}

TEST_CASE("Q is orthonormal and R upper triangular, and their product is the matrix") {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const MatrixXd A = random_matrix(random, random_size(random), random_size(random));
    const QrParts qr = qr_decomposition(A);
    const Index k = std::min(A.rows(), A.cols());
    CHECK(distance(qr.Q * qr.R, A) < kTight);
    CHECK(distance(qr.Q.transpose() * qr.Q, identity(k)) < kTight);
    CHECK(qr.R.isUpperTriangular(0.0));
    CHECK(qr.R.diagonal().minCoeff() >= 0.0);
  }
}

TEST_CASE("Cholesky's factor is lower triangular and its square is the matrix") {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    const Index n = random_size(random);
    const MatrixXd B = random_matrix(random, n, n);
    const MatrixXd A = B * B.transpose() + identity(n);
    const MatrixXd L = cholesky(A).value();
    CHECK(distance(L * L.transpose(), A) < kTight);
    CHECK(L.isLowerTriangular(0.0));
  }
  CHECK(cholesky(MatrixXd{{1, 2}, {3, 1}}).error().code == "not_symmetric");
  CHECK(cholesky(MatrixXd{{1, 2}, {2, 1}}).error().code == "not_positive");
  CHECK(cholesky(MatrixXd{{1, 2}, {2, 1}}).error().message == "its smallest eigenvalue is -1");
}

TEST_CASE("singular values and vectors reproduce the matrix") {
  Random random(7);
  for (int i = 0; i < 100; ++i) {
    const Index size = i < 98 ? 0 : 80;  // the last two are large
    const MatrixXd A =
        random_matrix(random, random_size(random) + size, random_size(random) + size);
    const SvdParts svd = singular_values(A);
    const Index k = std::min(A.rows(), A.cols());
    CHECK(distance(svd.U * svd.s.asDiagonal() * svd.V.transpose(), A) < kTight);
    CHECK(distance(svd.U.transpose() * svd.U, identity(k)) < kTight);
    CHECK(distance(svd.V.transpose() * svd.V, identity(k)) < kTight);
    CHECK(svd.s.minCoeff() >= 0.0);
    for (Index j = 1; j < k; ++j) CHECK(svd.s[j] <= svd.s[j - 1]);
  }
}

TEST_CASE("square U and V complete the directions that a matrix reaches and sees") {
  Random random(23);
  for (const auto& [rows, cols] : {std::pair<Index, Index>{3, 7}, {7, 3}, {6, 6}, {1, 4}}) {
    const MatrixXd A = random_matrix(random, rows, cols);
    const SvdParts thin = singular_values(A);
    const SvdParts full = full_singular_values(A);
    CHECK((full.s - thin.s).cwiseAbs().maxCoeff() < 1e-14);
    CHECK(distance(full.U.transpose() * full.U, identity(rows)) < kTight);
    CHECK(distance(full.V.transpose() * full.V, identity(cols)) < kTight);
    const auto k = full.s.size();
    CHECK((A * full.V.rightCols(cols - k)).norm() < 1e-13);
    CHECK((A.transpose() * full.U.rightCols(rows - k)).norm() < 1e-13);
  }
}

TEST_CASE("singular values of a 2x2 matrix are those of the closed form") {
  const VectorXd s = singular_values(MatrixXd{{1, 2}, {3, 4}}).s;
  CHECK(s[0] == doctest::Approx(std::sqrt(15 + std::sqrt(221.0))).epsilon(1e-15));
  CHECK(s[1] == doctest::Approx(std::sqrt(15 - std::sqrt(221.0))).epsilon(1e-14));
}

TEST_CASE("singular values of large matrices: second differences, and products of few columns") {
  for (const Index size : {32, 33, 200, 400}) {
    CAPTURE(size);
    MatrixXd A = 2.0 * identity(size);
    for (Index i = 1; i < size; ++i) A(i, i - 1) = A(i - 1, i) = -1.0;
    const VectorXd s = singular_values(A).s;
    for (Index k = 0; k < size; ++k) {
      const double angle =
          std::numbers::pi * static_cast<double>(size - k) / static_cast<double>(size + 1);
      CHECK(std::abs(s[k] - (2.0 - 2.0 * std::cos(angle))) < kTight);
    }
  }
  Random random(24);
  const MatrixXd few = random_matrix(random, 400, 5) * random_matrix(random, 5, 390);
  const SvdParts svd = full_singular_values(few);
  CHECK(rank(few) == 5);
  CHECK(svd.s[5] < 1e-14 * svd.s[0] * 400);
  CHECK(distance(svd.U.leftCols(390) * svd.s.asDiagonal() * svd.V.transpose(), few) < 1e-11);
  CHECK(distance(svd.U.transpose() * svd.U, identity(400)) < kTight);
  CHECK(distance(svd.V.transpose() * svd.V, identity(390)) < kTight);
  const VectorXd equal = singular_values(3.0 * identity(400)).s;
  CHECK((equal.array() == 3.0).all());
}

TEST_CASE("symmetric matrices have orthonormal eigenvectors, in ascending order") {
  Random random(8);
  for (int i = 0; i < 200; ++i) {
    const Index n = random_size(random);
    const MatrixXd B = random_matrix(random, n, n);
    const MatrixXd A = B + B.transpose();
    const EigenParts eig = eigenvectors(A).value();
    CHECK(distance(A * eig.vectors, eig.vectors * eig.values.asDiagonal()) < kTight);
    CHECK(distance(eig.vectors.transpose() * eig.vectors, identity(n)) < kTight);
    for (Index j = 1; j < n; ++j) CHECK(eig.values[j - 1] <= eig.values[j]);
    CHECK(distance(eig.values, eigenvalues(A).value().re) < kTight);
  }
}

TEST_CASE("a matrix made from eigenvalues and vectors has them") {
  Random random(9);
  for (int i = 0; i < 100; ++i) {
    const Index n = random_size(random);
    VectorXd values(n);
    for (Index j = 0; j < n; ++j) values[j] = static_cast<double>(j) - random.uniform(0.0, 0.5);
    const MatrixXd V = random_regular(random, n);
    const MatrixXd A = V * values.asDiagonal() * V.inverse();
    const EigenParts eig = eigenvectors(A).value();
    CHECK(distance(eig.values, values) < 1e-10);  // conditioned like V, below 100
    CHECK(distance(A * eig.vectors, eig.vectors * eig.values.asDiagonal()) < 1e-10);
    for (const auto& column : eig.vectors.colwise()) {
      CHECK(column.norm() == doctest::Approx(1.0));
      CHECK(column.maxCoeff() >= -column.minCoeff() * (1 - 1e-7));
    }
  }
}

TEST_CASE("eigenvalues of second differences are those of the closed form") {
  constexpr Index kSize = 6;
  MatrixXd A = 2.0 * identity(kSize);
  for (Index i = 1; i < kSize; ++i) A(i, i - 1) = A(i - 1, i) = -1.0;
  const VectorXd values = eigenvectors(A).value().values;
  for (Index k = 0; k < kSize; ++k) {
    const double angle = std::numbers::pi * static_cast<double>(k + 1) / (kSize + 1);
    CHECK(values[k] == doctest::Approx(2.0 - 2.0 * std::cos(angle)).epsilon(1e-13));
  }
}

TEST_CASE(
    "eigenvalues sum up to the trace and multiply to the determinant; complex ones in pairs") {
  Random random(10);
  int complex = 0;
  for (int i = 0; i < 200; ++i) {
    const Index n = 1 + random_size(random);
    const MatrixXd A = random_matrix(random, n, n);
    const EigenvalueParts values = eigenvalues(A).value();
    CHECK(values.re.sum() == doctest::Approx(A.trace()).epsilon(1e-10));
    CHECK(std::abs(values.im.sum()) < kTight);
    std::complex<double> product = 1.0;
    for (Index j = 0; j < n; ++j) product *= std::complex(values.re[j], values.im[j]);
    CHECK(product.real() == doctest::Approx(determinant(A).value()).epsilon(1e-9));
    if (values.im.cwiseAbs().maxCoeff() == 0.0) continue;
    ++complex;
    CHECK(eigenvectors(A).error().code == "complex");
  }
  CHECK(complex > 100);
  const EigenvalueParts turn = eigenvalues(MatrixXd{{0, -1}, {1, 0}}).value();
  CHECK(turn.re.cwiseAbs().maxCoeff() < 1e-15);
  CHECK(distance(turn.im, VectorXd{{-1, 1}}) < 1e-15);
}

TEST_CASE("the determinant of a product is the product of the determinants") {
  Random random(11);
  for (int i = 0; i < 200; ++i) {
    const Index n = random_size(random);
    const MatrixXd A = random_matrix(random, n, n);
    const MatrixXd B = random_matrix(random, n, n);
    const double both = determinant(A).value() * determinant(B).value();
    CHECK(std::abs(determinant(A * B).value() - both) < kTight);
  }
}

// Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., 2002, section 28.1.
TEST_CASE("Hilbert's matrix has the inverse and the determinant of the books") {
  MatrixXd H(5, 5);
  for (Index i = 0; i < 5; ++i) {
    for (Index j = 0; j < 5; ++j) H(i, j) = 1.0 / static_cast<double>(i + j + 1);
  }
  CHECK(determinant(H).value() == doctest::Approx(1.0 / 266716800000.0).epsilon(1e-10));
  const MatrixXd inv = inverse(H.topLeftCorner(3, 3)).value();
  CHECK(distance(inv, MatrixXd{{9, -36, 30}, {-36, 192, -180}, {30, -180, 180}}) < 1e-10);
  CHECK(rank(H) == 5);
}

TEST_CASE("the rank counts independent rows") {
  Random random(12);
  for (int i = 0; i < 100; ++i) {
    const Index r = random_size(random);
    const MatrixXd left = random_matrix(random, r + random_size(random), r);
    const MatrixXd right = random_matrix(random, r, r + random_size(random));
    CHECK(rank(left * right) == r);
  }
  CHECK(rank(MatrixXd::Zero(3, 2)) == 0);
  CHECK(rank(MatrixXd{{16, 2, 3, 13}, {5, 11, 10, 8}, {9, 7, 6, 12}, {4, 14, 15, 1}}) == 3);
}

TEST_CASE("singular matrices are refused with their rank") {
  const MatrixXd A{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  CHECK(inverse(A).error().code == "singular");
  CHECK(inverse(A).error().message == "its rank is 2, but 3 independent rows are needed");
  CHECK(solve(MatrixXd{{1, 2}, {2, 4}, {3, 6}}, VectorXd::Ones(3)).error().message ==
        "its rank is 1, but 2 independent columns are needed");
  CHECK(solve(MatrixXd{{1, 2, 3}, {2, 4, 6}}, VectorXd::Ones(2)).error().code == "singular");
  CHECK(inverse(MatrixXd::Zero(1, 1)).error().message ==
        "its rank is 0, but 1 independent row is needed");
  CHECK(inverse(MatrixXd::Constant(1, 1, 1e-300)).value()(0, 0) == doctest::Approx(1e300));
  CHECK(inverse(MatrixXd::Constant(1, 1, 1e-310)).error().code == "overflow");
}

TEST_CASE("the exponential is the square of that of the half, and undone by that of the negative") {
  Random random(13);
  for (int i = 0; i < 100; ++i) {
    const Index n = random_size(random);
    const MatrixXd A = 3.0 * random_matrix(random, n, n);
    const MatrixXd whole = exponential(A).value();
    const MatrixXd half = exponential(0.5 * A).value();
    const double size = whole.cwiseAbs().maxCoeff();
    CHECK(distance(whole, half * half) < 1e-11 * std::max(1.0, size));
    CHECK(distance(whole * exponential(-A).value(), identity(n)) < 1e-8 * size);
    CHECK(whole.determinant() == doctest::Approx(std::exp(A.trace())).epsilon(1e-6));
  }
}

TEST_CASE("exponentials of rotations, of nilpotents, and of Moler and Van Loan's example") {
  for (const double t : {0.1, 1.0, 10.0, 100.0}) {
    const MatrixXd turn = exponential(MatrixXd{{0, -t}, {t, 0}}).value();
    CHECK(distance(turn, MatrixXd{{std::cos(t), -std::sin(t)}, {std::sin(t), std::cos(t)}}) <
          1e-14 * (1 + t));
  }
  CHECK(distance(exponential(MatrixXd{{0, 1, 2}, {0, 0, 3}, {0, 0, 0}}).value(),
                 MatrixXd{{1, 1, 3.5}, {0, 1, 3}, {0, 0, 1}}) < 1e-15);
  // C. Moler, C. Van Loan, SIAM Review 45(1), 2003, section 3.
  CHECK(distance(exponential(MatrixXd{{-49, 24}, {-64, 31}}).value(),
                 MatrixXd{{-0.735759, 0.551819}, {-1.471518, 1.103638}}) < 1e-6);
  CHECK(exponential(MatrixXd::Constant(1, 1, 1000.0)).error().code == "overflow");
  CHECK(exponential(MatrixXd::Constant(2, 2, 1e300)).error().code == "overflow");
}

TEST_CASE("matrices without elements have answers too") {
  const MatrixXd none(0, 0);
  CHECK(determinant(none).value() == 1.0);
  CHECK(rank(none) == 0);
  CHECK(inverse(none).value().size() == 0);
  CHECK(eigenvectors(none).value().values.size() == 0);
  CHECK(exponential(none).value().size() == 0);
  CHECK(cholesky(none).value().size() == 0);
  CHECK(lu_decomposition(none).L.size() == 0);
  CHECK(qr_decomposition(MatrixXd(3, 0)).Q.cols() == 0);
  CHECK(singular_values(MatrixXd(0, 4)).s.size() == 0);
  CHECK(solve(MatrixXd(0, 2), MatrixXd(0, 1)).value() == MatrixXd::Zero(2, 1));
}

TEST_CASE("what cannot be decomposed is refused") {
  const MatrixXd oblong = MatrixXd::Ones(2, 3);
  CHECK_THROWS_AS((void)determinant(oblong), ArgumentError);
  CHECK_THROWS_AS((void)eigenvalues(oblong), ArgumentError);
  CHECK_THROWS_AS((void)exponential(oblong), ArgumentError);
  CHECK_THROWS_AS((void)lu_decomposition(oblong), ArgumentError);
  CHECK_THROWS_AS((void)solve(oblong, VectorXd::Ones(3)), ArgumentError);
  MatrixXd bad = identity(2);
  bad(1, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS((void)singular_values(bad), ArgumentError);
  CHECK_THROWS_AS((void)qr_decomposition(bad), ArgumentError);
  CHECK_THROWS_AS((void)rank(MatrixXd::Zero(kMostDecomposed + 1, 1)), ArgumentError);
}
