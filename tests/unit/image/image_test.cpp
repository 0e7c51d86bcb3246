#include "armlet/image/image.hpp"

#include <doctest/doctest.h>

#include "armlet/core/error.hpp"

using namespace armlet;

TEST_CASE("a picture is black first and keeps what is stored in it") {
  Image image(5, 3, PixelKind::kRgb);
  CHECK(image.channels() == 3);
  CHECK(image.bytes().size() == 45);
  image.row(2)[3 * 4 + 1] = 200;
  CHECK(image.bytes().back() == 0);
  CHECK(image.bytes()[43] == 200);
  Image copy = image;
  CHECK(copy == image);
  copy.row(0)[0] = 1;
  CHECK_FALSE(copy == image);
  CHECK(Image(2, 2, PixelKind::kDepth).depths().size() == 4);
}

TEST_CASE("sides of pictures are limited") {
  CHECK_THROWS_WITH_AS(Image(0, 5, PixelKind::kGrey),
                       "A picture has sides of 1 to 8192 pixels, not 0 x 5.", ArgumentError);
  CHECK_THROWS_AS(Image(100'000, 100'000, PixelKind::kRgb), ArgumentError);
}
