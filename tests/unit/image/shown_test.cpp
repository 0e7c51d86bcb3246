#include "armlet/image/shown.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"

using namespace armlet;

namespace {

Image depths_of(const std::vector<float>& values) {
  Image image(static_cast<int>(values.size()), 1, PixelKind::kDepth);
  std::ranges::copy(values, image.depth_row(0));
  return image;
}

std::vector<std::uint8_t> bytes_of(const Image& image) {
  return {image.bytes().begin(), image.bytes().end()};
}

Image noise(Random& random, int width, int height, PixelKind kind) {
  Image image(width, height, kind);
  for (int y = 0; y < height; ++y)
    for (int i = 0; i < width * image.channels(); ++i)
      image.row(y)[i] = static_cast<std::uint8_t>(random.uniform() * 256.0);
  return image;
}

}  // namespace

TEST_CASE("the nearest depth is white, the farthest dark, and nothing black") {
  const float inf = std::numeric_limits<float>::infinity();
  const Image depths = depths_of({0.5F, 1.0F, 0.75F, 0.0F, inf, std::nanf(""), -1.0F});
  CHECK(depth_range(depths).nearest == 0.5F);
  CHECK(depth_range(depths).farthest == 1.0F);
  CHECK(bytes_of(grey_of_depths(depths)) == std::vector<std::uint8_t>{255, 30, 143, 0, 0, 0, 0});
}

TEST_CASE("depths that are all the same, none, tiny or huge have grey levels") {
  CHECK(bytes_of(grey_of_depths(depths_of({2.0F, 2.0F}))) == std::vector<std::uint8_t>{255, 255});
  CHECK(bytes_of(grey_of_depths(depths_of({0.5F, 0.50000006F}))) ==
        std::vector<std::uint8_t>{255, 255});
  CHECK(bytes_of(grey_of_depths(depths_of({0.0F}))) == std::vector<std::uint8_t>{0});
  CHECK(depth_range(depths_of({0.0F})).farthest == 0.0F);
  const float most = std::numeric_limits<float>::max();
  const float least = std::numeric_limits<float>::denorm_min();
  CHECK(bytes_of(grey_of_depths(depths_of({least, most}))) == std::vector<std::uint8_t>{255, 30});
  CHECK_THROWS_AS((void)grey_of_depths(Image(2, 2, PixelKind::kGrey)), ArgumentError);
}

TEST_CASE("each pixel of a smaller picture is the mean of a block") {
  Image image(4, 2, PixelKind::kRgb);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 4; ++x)
      for (int c = 0; c < 3; ++c)
        image.row(y)[3 * x + c] = static_cast<std::uint8_t>(10 * x + 100 * y + c);
  CHECK(bytes_of(resized(image, 2, 1)) == std::vector<std::uint8_t>{55, 56, 57, 75, 76, 77});
}

TEST_CASE("a multiple of the size repeats pixels, and back again gives the same picture") {
  Random random(7);
  for (const PixelKind kind : {PixelKind::kGrey, PixelKind::kRgb}) {
    for (int k = 0; k < 30; ++k) {
      const int width = 1 + static_cast<int>(random.uniform() * 20.0);
      const int height = 1 + static_cast<int>(random.uniform() * 20.0);
      const Image image = noise(random, width, height, kind);
      CHECK(resized(image, width, height) == image);
      CHECK(resized(resized(image, 3 * width, 2 * height), width, height) == image);
    }
  }
}

TEST_CASE("every size is filled from pixels of the picture: no level is beyond theirs") {
  Random random(8);
  for (int k = 0; k < 60; ++k) {
    const auto side = [&random] { return 1 + static_cast<int>(random.uniform() * 70.0); };
    const Image image = noise(random, side(), side(), PixelKind::kGrey);
    const auto [low, high] = std::ranges::minmax_element(image.bytes());
    const Image other = resized(image, side(), side());
    for (const std::uint8_t level : other.bytes()) {
      CHECK(level >= *low);
      CHECK(level <= *high);
    }
  }
  CHECK(resized(Image(8192, 1, PixelKind::kGrey), 3, 2).height() == 2);
}

TEST_CASE("a side out of range and depths are refused") {
  CHECK_THROWS_AS((void)resized(Image(2, 2, PixelKind::kGrey), 0, 1), ArgumentError);
  CHECK_THROWS_AS((void)resized(Image(2, 2, PixelKind::kGrey), 1, 8193), ArgumentError);
  CHECK_THROWS_AS((void)resized(Image(2, 2, PixelKind::kDepth), 1, 1), ArgumentError);
  CHECK_THROWS_AS((void)resized(Image(), 1, 1), ArgumentError);
}
