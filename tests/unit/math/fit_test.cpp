#include "armlet/math/fit.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/math/polynomial.hpp"
#include "matrices.hpp"

using namespace armlet;
using Eigen::VectorXd;

// NIST Statistical Reference Datasets, Linear Regression, Wampler1 and Wampler2: y = sum x^k and
// y = sum (x / 10)^k, k = 0 to 5, at x = 0 to 20, with the certified parameters 1 and 10^-k.
TEST_CASE("the certified parameters of Wampler's data are met") {
  for (const double step : {1.0, 0.1}) {
    VectorXd x(21), y(21), certified(6);
    for (int k = 0; k < 6; ++k) certified[k] = std::pow(step, k);
    for (int i = 0; i <= 20; ++i) {
      x[i] = i;
      y[i] = polynomial_value(certified, x[i]);
    }
    const VectorXd c = fit_polynomial(x, y, 5);
    REQUIRE(c.size() == 6);
    // The values of y reach four million, so that 1e-9 is their rounding.
    for (int k = 0; k < 6; ++k) CHECK(c[k] == doctest::Approx(certified[k]).epsilon(1e-8));
  }
}

TEST_CASE("the line of least squares through three points") {
  // By hand: slope 3/2, at x = 0 it is 5/6.
  const VectorXd c = fit_polynomial(vec({0, 1, 2}), vec({1, 2, 4}), 1);
  CHECK(c[0] == doctest::Approx(5.0 / 6.0));
  CHECK(c[1] == doctest::Approx(1.5));
}

TEST_CASE("what is left of a fit is at right angles to every power") {
  Random random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const int degree = trial % 7;
    VectorXd x(30), y(30);
    for (int i = 0; i < 30; ++i) {
      x[i] = random.uniform(-2.0, 5.0);
      y[i] = random.uniform(-1.0, 1.0);
    }
    const VectorXd c = fit_polynomial(x, y, degree);
    for (int k = 0; k <= degree; ++k) {
      double product = 0.0;
      double size = 0.0;
      for (int i = 0; i < 30; ++i) {
        const double power = std::pow(x[i], k);
        product += power * (y[i] - polynomial_value(c, x[i]));
        size += std::abs(power);
      }
      CHECK(std::abs(product) < 1e-10 * size);
    }
  }
}

TEST_CASE("far from zero and in small units a fit is as good as elsewhere") {
  VectorXd x(5), y(5);
  for (int i = 0; i < 5; ++i) {
    x[i] = 1000.0 + 1e-3 * i;
    y[i] = 7.0 + 2.0 * i;
  }
  const VectorXd c = fit_polynomial(x, y, 1);
  CHECK(c[1] == doctest::Approx(2000.0).epsilon(1e-9));
  CHECK(fit_polynomial(vec({3}), vec({4}), 0)[0] == doctest::Approx(4.0));
}

TEST_CASE("impossible fits are refused") {
  CHECK_THROWS_AS(fit_polynomial(vec({1, 2}), vec({1}), 1), ArgumentError);
  CHECK_THROWS_WITH_AS(fit_polynomial(vec({1, 1, 1}), vec({1, 2, 3}), 1),
                       "A polynomial of degree 1 needs 2 points with different x, and there is 1.",
                       ArgumentError);
  CHECK_THROWS_AS(fit_polynomial(vec({1, 2}), vec({1, 2}), -1), ArgumentError);
  CHECK_THROWS_AS(fit_polynomial(vec({1, NAN}), vec({1, 2}), 1), ArgumentError);
}

TEST_CASE("values between points lie on the lines and are exact at the points") {
  const VectorXd x = vec({0, 1, 3, 10});
  const VectorXd y = vec({5, 7, -1, 0.1});
  for (int i = 0; i < 4; ++i) CHECK(value_between(x, y, x[i]) == y[i]);
  CHECK(value_between(x, y, 0.25) == doctest::Approx(5.5));
  CHECK(value_between(x, y, 2.5) == doctest::Approx(1.0));
  CHECK(value_between(vec({2}), vec({3}), 2.0) == 3.0);
}

TEST_CASE("values outside, points out of order and no points are refused") {
  const VectorXd x = vec({0, 1});
  CHECK_THROWS_AS(value_between(x, x, 1.1), ArgumentError);
  CHECK_THROWS_AS(value_between(x, x, -0.1), ArgumentError);
  CHECK_THROWS_AS(value_between(vec({0, 0}), x, 0.0), ArgumentError);
  CHECK_THROWS_AS(value_between(vec({1, 0}), x, 0.5), ArgumentError);
  CHECK_THROWS_AS(value_between(VectorXd(), VectorXd(), 0.5), ArgumentError);
  CHECK_THROWS_AS(value_between(x, vec({1}), 0.5), ArgumentError);
  CHECK_THROWS_AS(value_between(x, x, NAN), ArgumentError);
}
