#include "armlet/math/angles.hpp"

#include <doctest/doctest.h>

using namespace armlet;

TEST_CASE("angles wrap into the half-open revolution above -180 degrees") {
  CHECK(wrap_angle(0.0) == 0.0);
  CHECK(wrap_angle(kPi) == kPi);
  CHECK(wrap_angle(-kPi) == kPi);
  CHECK(wrap_angle(deg_to_rad(350.0)) == doctest::Approx(deg_to_rad(-10.0)));
  CHECK(wrap_angle(deg_to_rad(-190.0)) == doctest::Approx(deg_to_rad(170.0)));
  for (int k = -720; k <= 720; ++k) {
    const double wrapped = wrap_angle(deg_to_rad(k));
    CHECK(wrapped > -kPi);
    CHECK(wrapped <= kPi);
  }
}

TEST_CASE("the difference of two angles is the smaller one") {
  CHECK(angle_difference(deg_to_rad(170.0), deg_to_rad(-170.0)) ==
        doctest::Approx(deg_to_rad(-20.0)));
  CHECK(rad_to_deg(angle_difference(deg_to_rad(10.0), deg_to_rad(350.0))) == doctest::Approx(20.0));
}

TEST_CASE("the nearest multiple of a revolution is at most half a revolution away") {
  CHECK(nearest_copy_of_angle(0.1, 6.2) == doctest::Approx(0.1 + 2.0 * kPi));
  CHECK(nearest_copy_of_angle(3.0, -3.0) == doctest::Approx(3.0 - 2.0 * kPi));
  CHECK(nearest_copy_of_angle(1.0, 1.2) == doctest::Approx(1.0));
}
