#include "armlet/math/real_roots.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "matrices.hpp"

using namespace armlet;
using Eigen::VectorXd;

namespace {

// (x - r1)(x - r2) ... times `factor`.
VectorXd with_roots(const std::vector<double>& roots, double factor = 1.0) {
  VectorXd c = VectorXd::Zero(static_cast<Eigen::Index>(roots.size()) + 1);
  c[0] = factor;
  Eigen::Index size = 1;
  for (const double root : roots) {
    for (Eigen::Index i = size; i > 0; --i) c[i] = c[i - 1] - root * c[i];
    c[0] *= -root;
    ++size;
  }
  return c;
}

}  // namespace

// M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions, 1964, table 25.4, n = 5.
TEST_CASE("the zeros of the Legendre polynomial of degree 5") {
  const auto roots = real_roots(vec({0.0, 15.0 / 8, 0.0, -70.0 / 8, 0.0, 63.0 / 8}));
  REQUIRE(roots.size() == 5);
  CHECK(roots[0] == doctest::Approx(-0.906179845938664).epsilon(1e-14));
  CHECK(roots[1] == doctest::Approx(-0.538469310105683).epsilon(1e-14));
  CHECK(roots[2] == 0.0);
  CHECK(roots[3] == doctest::Approx(0.538469310105683).epsilon(1e-14));
  CHECK(roots[4] == doctest::Approx(0.906179845938664).epsilon(1e-14));
}

TEST_CASE("Chebyshev polynomials have the cosines they are made of as zeros") {
  VectorXd before = vec({1.0});
  VectorXd here = vec({0.0, 1.0});
  for (int n = 2; n <= 12; ++n) {
    VectorXd next = VectorXd::Zero(n + 1);
    next.tail(n) = 2.0 * here;
    next.head(before.size()) -= before;
    before = here;
    here = next;
    const auto roots = real_roots(here);
    REQUIRE(roots.size() == static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k) {
      const double expected = -std::cos((2.0 * k + 1.0) * std::numbers::pi / (2.0 * n));
      CHECK(std::abs(roots[k] - expected) < 1e-11);  // coefficients up to 6912 cancel
    }
  }
}

// J. H. Wilkinson, Rounding Errors in Algebraic Processes, 1963: the first members of his family.
TEST_CASE("the zeros 1 to 10 are found from the expanded product") {
  const auto roots = real_roots(with_roots({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
  REQUIRE(roots.size() == 10);
  for (int k = 0; k < 10; ++k) CHECK(std::abs(roots[k] - (k + 1)) < 1e-7);
}

TEST_CASE("random zeros are found, whatever the size of the coefficients") {
  Random random(17);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<double> expected;
    double at = random.uniform(-3.0, 0.0);
    for (int k = 0; k < 1 + trial % 5; ++k) expected.push_back(at += random.uniform(0.2, 1.5));
    const double unit = std::pow(10.0, random.uniform(-6.0, 6.0));
    for (double& root : expected) root *= unit;
    const auto roots = real_roots(with_roots(expected, random.uniform(-5.0, 5.0)));
    REQUIRE(roots.size() == expected.size());
    for (std::size_t k = 0; k < roots.size(); ++k)
      CHECK(std::abs(roots[k] - expected[k]) < 1e-10 * unit);
  }
}

TEST_CASE("pairs of complex zeros are left out") {
  CHECK(real_roots(vec({1.0, 0.0, 1.0})).empty());
  CHECK(real_roots(vec({1.0, 1.0, 1.0, 0.0, 0.0})).empty());
  const auto one = real_roots(vec({-1.0, 0.0, 0.0, 1.0}));  // x^3 = 1
  REQUIRE(one.size() == 1);
  CHECK(one[0] == doctest::Approx(1.0).epsilon(1e-15));
}

TEST_CASE("a multiple zero is listed once") {
  for (const double root : {1.0, 1.0 / 3.0, -7.3}) {
    for (std::size_t times = 2; times <= 6; ++times) {
      std::vector<double> all(times, root);
      all.push_back(root + 2.0);
      const auto roots = real_roots(with_roots(all));
      REQUIRE(roots.size() == 2);
      // The centre of a multiple zero is kept by the derivatives.
      CHECK(std::abs(roots[0] - root) < 1e-3);
      CHECK(std::abs(roots[1] - root - 2.0) < 1e-9);
    }
  }
}

TEST_CASE("lines, constants and zeros at zero") {
  CHECK(real_roots(vec({3.0})).empty());
  CHECK(real_roots(vec({3.0, -2.0})) == std::vector<double>{1.5});
  CHECK(real_roots(vec({0.0, 0.0, 5.0})) == std::vector<double>{0.0});
  CHECK(real_roots(vec({0.0, -1.0, 1.0, 0.0})) == std::vector<double>{0.0, 1.0});
}

TEST_CASE("what is no polynomial with roots is refused") {
  CHECK_THROWS_AS(real_roots(vec({0.0, 0.0})), ArgumentError);
  CHECK_THROWS_AS(real_roots(VectorXd()), ArgumentError);
  CHECK_THROWS_AS(real_roots(vec({1.0, NAN})), ArgumentError);
  CHECK_THROWS_AS(real_roots(VectorXd::Ones(60)), ArgumentError);
  CHECK_THROWS_AS(real_roots(vec({1e300, 1.0, 1e-300})), ArgumentError);
}
