#include "armlet/math/linalg.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "matrices.hpp"

using namespace armlet;
using Eigen::MatrixXd;

TEST_CASE("the pseudo-inverse meets Penrose's four conditions, also without full rank") {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const int rows = 1 + static_cast<int>(random.below(6));
    const int cols = 1 + static_cast<int>(random.below(6));
    MatrixXd A = random_matrix(random, rows, cols);
    if (i % 3 == 0) A.row(rows - 1) = A.row(0);
    const MatrixXd P = damped_pseudo_inverse(A);
    // Random 6x6 matrices are conditioned to about 1e4 at worst, which costs as many digits.
    const double tolerance = 1e-10 * std::max(1.0, P.norm());
    CHECK((A * P * A - A).norm() < tolerance);
    CHECK((P * A * P - P).norm() < tolerance * std::max(1.0, P.norm()));
    CHECK((A * P - (A * P).transpose()).norm() < tolerance);
    CHECK((P * A - (P * A).transpose()).norm() < tolerance);
  }
}

TEST_CASE("damping solves the regularised normal equations") {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const MatrixXd J = random_matrix(random, 6, 7);
    const double lambda = random.uniform(0.01, 1.0);
    const MatrixXd G = J * J.transpose() + lambda * lambda * MatrixXd::Identity(6, 6);
    CHECK((damped_pseudo_inverse(J, lambda) - J.transpose() * G.inverse()).norm() < 1e-10);
  }
}

TEST_CASE("the null space projector lets through exactly what the matrix does not see") {
  Random random(3);
  const MatrixXd J = random_matrix(random, 6, 9);
  const MatrixXd N = null_space_projector(J);
  CHECK((J * N).norm() < 1e-13);
  CHECK((N * N - N).norm() < 1e-13);
  CHECK(N.trace() == doctest::Approx(3.0));
  CHECK(null_space_projector(MatrixXd::Zero(2, 3)).isIdentity());
}

TEST_CASE("the condition number of a diagonal matrix is the ratio of its ends") {
  CHECK(condition_number(Eigen::Vector3d(8, 2, 4).asDiagonal()) == doctest::Approx(4.0));
  CHECK(std::isinf(condition_number(MatrixXd::Zero(2, 2))));
}

TEST_CASE("input that is not finite is refused") {
  MatrixXd A = MatrixXd::Identity(2, 2);
  CHECK_THROWS_AS(damped_pseudo_inverse(A, -1.0), ArgumentError);
  CHECK_THROWS_AS(condition_number(MatrixXd()), ArgumentError);
  A(0, 1) = NAN;
  CHECK_THROWS_AS(damped_pseudo_inverse(A), ArgumentError);
  CHECK_THROWS_AS(null_space_projector(A), ArgumentError);
}
