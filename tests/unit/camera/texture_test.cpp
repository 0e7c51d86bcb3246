#include "armlet/camera/texture.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/error.hpp"

using namespace armlet;

TEST_CASE("linear light of a byte leads back to the byte") {
  for (int byte = 0; byte < 256; ++byte) {
    const auto b = static_cast<std::uint8_t>(byte);
    const double x = byte / 255.0;
    const double expected = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    CHECK(linear_of(b) == doctest::Approx(expected).epsilon(1e-6));
    CHECK(byte_of(linear_of(b)) == b);
  }
  CHECK(byte_of(-1.0F) == 0);
  CHECK(byte_of(7.0F) == 255);
  CHECK(byte_of(std::nanf("")) == 0);
}

TEST_CASE("pixels of a picture are found at their centres and mixed between them") {
  Image picture(4, 2, PixelKind::kGrey);
  for (int x = 0; x < 4; ++x)
    picture.row(0)[x] = picture.row(1)[x] = static_cast<std::uint8_t>(60 * x);
  const Texture texture(picture);
  for (int x = 0; x < 4; ++x) {
    const float u = (static_cast<float>(x) + 0.5F) / 4.0F;
    CHECK(texture.value(u, 0.25F, 1.0F)[0] == doctest::Approx(60.0 * x));
    CHECK(texture.value(u, 0.25F, 1.0F)[2] == doctest::Approx(60.0 * x));
  }
  CHECK(texture.value(0.25F, 0.5F, 1.0F)[1] == doctest::Approx(30.0));
  CHECK(texture.value(-3.0F, 0.5F, 1.0F)[1] == 0.0F);
  CHECK(texture.value(3.0F, 0.5F, 1.0F)[1] == 180.0F);
}

TEST_CASE("far away a picture is its mean") {
  Image picture(64, 32, PixelKind::kRgb);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) picture.row(y)[3 * x] = (x + y) % 2 == 0 ? 200 : 100;
  }
  const Texture texture(picture);
  for (const float footprint : {2.0F, 8.0F, 1e5F, 1e30F})
    CHECK(texture.value(0.3F, 0.7F, footprint)[0] == doctest::Approx(150.0));
  CHECK_THROWS_AS((void)Texture{Image{}}, ArgumentError);
  CHECK_THROWS_AS((void)Texture{Image(4, 4, PixelKind::kDepth)}, ArgumentError);
}
