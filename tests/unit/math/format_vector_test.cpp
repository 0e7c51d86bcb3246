#include "armlet/math/format_vector.hpp"

#include <doctest/doctest.h>

using namespace armlet;

TEST_CASE("vectors are shown in brackets") {
  CHECK(format_vector(Eigen::Vector3d(0.1, 2.0, -3.25)) == "(0.1, 2, -3.25)");
  CHECK(format_vector(Eigen::VectorXd()) == "()");
  CHECK(format_point_mm({0.18, -0.2642, 0.02}) == "(180, -264.2, 20) mm");
}
