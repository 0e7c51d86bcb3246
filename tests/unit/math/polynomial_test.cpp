#include "armlet/math/polynomial.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"

using namespace armlet;
using Eigen::VectorXd;

TEST_CASE("values and derivatives follow from the coefficients") {
  const VectorXd c = Eigen::Vector4d(1, -2, 3, 0.5);  // 1 - 2 t + 3 t^2 + t^3 / 2
  CHECK(polynomial_value(c, 2.0) == doctest::Approx(13.0));
  CHECK(polynomial_value(c, 2.0, 1) == doctest::Approx(16.0));
  CHECK(polynomial_value(c, 2.0, 2) == doctest::Approx(12.0));
  CHECK(polynomial_value(c, 2.0, 4) == 0.0);
  CHECK(polynomial_derivative(c) == VectorXd(Eigen::Vector3d(-2, 6, 1.5)));
  CHECK(polynomial_derivative(VectorXd::Ones(1)) == VectorXd::Zero(1));
}

TEST_CASE("a fitted polynomial meets its conditions at both ends") {
  Random random(1);
  for (int m = 0; m <= 4; ++m) {
    for (int k = 0; k <= 4; ++k) {
      if (m + k == 0) continue;
      for (const double T : {1e-3, 1.0, 50.0}) {
        VectorXd start(m), end(k);
        // Derivatives of the size that a motion of length 1 in time T has.
        for (int i = 0; i < m; ++i) start[i] = random.uniform(-1, 1) / std::pow(T, i);
        for (int i = 0; i < k; ++i) end[i] = random.uniform(-1, 1) / std::pow(T, i);
        const VectorXd c = fit_boundary_polynomial(start, end, T);
        REQUIRE(c.size() == m + k);
        for (int i = 0; i < m; ++i)
          CHECK(std::abs(polynomial_value(c, 0, i) - start[i]) < 1e-11 / std::pow(T, i));
        for (int i = 0; i < k; ++i)
          CHECK(std::abs(polynomial_value(c, T, i) - end[i]) < 1e-11 / std::pow(T, i));
      }
    }
  }
}

// T. Flash and N. Hogan, J. Neuroscience 5(7), 1985: 10 s^3 - 15 s^4 + 6 s^5.
TEST_CASE("three conditions at rest at each end give the minimum-jerk law") {
  const VectorXd c =
      fit_boundary_polynomial(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), 1.0);
  VectorXd expected(6);
  expected << 0, 0, 0, 10, -15, 6;
  CHECK((c - expected).norm() < 1e-13);
}

TEST_CASE("impossible conditions are refused") {
  const VectorXd two = VectorXd::Zero(2);
  CHECK_THROWS_AS(fit_boundary_polynomial(two, two, 0.0), ArgumentError);
  CHECK_THROWS_AS(fit_boundary_polynomial(VectorXd(), VectorXd(), 1.0), ArgumentError);
  CHECK_THROWS_AS(fit_boundary_polynomial(VectorXd::Zero(5), two, 1.0), ArgumentError);
  CHECK_THROWS_AS(fit_boundary_polynomial(VectorXd::Constant(1, NAN), two, 1.0), ArgumentError);
}
