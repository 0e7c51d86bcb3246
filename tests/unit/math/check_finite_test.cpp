#include "armlet/math/check_finite.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace armlet;

TEST_CASE("an element that is not finite is reported with its index") {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2, 3);
  CHECK_NOTHROW(check_finite("A", A));
  A(1, 2) = NAN;
  CHECK_THROWS_WITH_AS(check_finite("A", A),
                       "Element (1, 2) of `A` is nan; it must be a finite number.", ArgumentError);
  CHECK_THROWS_WITH_AS(check_finite("q", Eigen::Vector2d(0.0, INFINITY)),
                       "Element 1 of `q` is inf; it must be a finite number.", ArgumentError);
}
