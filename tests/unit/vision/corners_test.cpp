#include "armlet/vision/corners.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "armlet/core/error.hpp"
#include "armlet/vision/correspondence.hpp"

using namespace armlet;

namespace {

// A dark picture with a bright rectangle of whole pixels, whose corners lie half a pixel outside of
// its outermost ones.
Image with_rectangle(int left, int top, int right, int bottom) {
  Image image(160, 120, PixelKind::kGrey);
  for (int y = top; y < bottom; ++y) std::fill(image.row(y) + left, image.row(y) + right, 200);
  return image;
}

}  // namespace

TEST_CASE("both detectors find the corners of a rectangle, and only these") {
  const Image image = with_rectangle(40, 30, 120, 90);
  PlanePoints expected(4, 2);
  expected << 39.5, 29.5, 119.5, 29.5, 39.5, 89.5, 119.5, 89.5;
  for (const CornerMethod method : {CornerMethod::kSusan, CornerMethod::kHarris}) {
    const PlanePoints found = find_corners(image, {.method = method});
    REQUIRE(found.rows() == 4);
    const Matches matches = match_points(found, expected, 1.0);
    CHECK(matches.lost().empty());
    // Bilinear brightness between pixels puts an ideal corner to within a third of a pixel.
    for (const double distance : matches.distance) CHECK(distance < 0.35);
    CHECK(find_corners(image, {.method = method, .max = 2}).rows() == 2);
    const PlanePoints whole = find_corners(image, {.method = method, .refine = false});
    CHECK(whole == whole.array().round().matrix());
  }
  CHECK(find_corners(Image(50, 40, PixelKind::kGrey)).rows() == 0);
}

TEST_CASE("corners around positions are those of the whole picture that are there") {
  const Image image = with_rectangle(40, 30, 120, 90);
  const PlanePoints all = find_corners(image);
  for (Eigen::Index i = 0; i < all.rows(); ++i) {
    const PlanePoints near = find_corners_around(image, all.row(i), 8.0);
    REQUIRE(near.rows() == 1);
    CHECK((near.row(0) - all.row(i)).norm() < 1e-9);
  }
  PlanePoints outside(1, 2);
  outside << -500.0, 30.0;
  CHECK(find_corners_around(image, outside, 10.0).rows() == 0);
  CHECK_THROWS_AS((void)find_corners_around(image, PlanePoints(0, 2), 10.0), ArgumentError);
  CHECK_THROWS_AS((void)find_corners(image, {.max = -1}), ArgumentError);
  CHECK_THROWS_AS((void)find_corners(Image(20, 20, PixelKind::kRgb)), ArgumentError);
}
