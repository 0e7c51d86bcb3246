#include "armlet/math/normal.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace armlet;

TEST_CASE("normal numbers have the moments of the normal distribution") {
  Random random(3);
  double m1 = 0.0, m2 = 0.0, m4 = 0.0;
  constexpr int kCount = 200'000;
  for (int i = 0; i < kCount; ++i) {
    const double x = normal(random);
    m1 += x / kCount;
    m2 += x * x / kCount;
    m4 += x * x * x * x / kCount;
  }
  // Four standard errors of each moment.
  CHECK(std::abs(m1) < 0.009);
  CHECK(std::abs(m2 - 1.0) < 0.013);
  CHECK(std::abs(m4 - 3.0) < 0.09);
}
