#include "armlet/image/arithmetic.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/error.hpp"
#include "random_image.hpp"
#include "refusal_of.hpp"

using namespace armlet;

namespace {

constexpr PixelKind kKinds[] = {PixelKind::kGrey, PixelKind::kRgb, PixelKind::kDepth};

}  // namespace

TEST_CASE("grey is the nearest level to the weighted sum of the colours") {
  Image image(256, 256, PixelKind::kRgb);
  std::mt19937_64 generator(1);
  image = random_image(generator, 200, 150, PixelKind::kRgb);
  const Image grey = to_grey(image);
  for (int y = 0; y < 150; ++y)
    for (int x = 0; x < 200; ++x) {
      const std::uint8_t* p = image.row(y) + 3 * x;
      const double exact = 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2];
      CHECK(std::abs(grey.row(y)[x] - exact) <= 0.5 + 1e-9);
    }
  for (int value = 0; value < 256; ++value) {
    Image flat(1, 1, PixelKind::kRgb);
    for (int c = 0; c < 3; ++c) flat.row(0)[c] = static_cast<std::uint8_t>(value);
    CHECK(to_grey(flat).row(0)[0] == value);
  }
  CHECK(to_grey(grey) == grey);
}

TEST_CASE("differences and sums of pictures: symmetry, limits, round trips") {
  std::mt19937_64 generator(2);
  for (int round = 0; round < 40; ++round) {
    for (const PixelKind kind : kKinds) {
      const Image a = random_image(generator, 17, 9, kind);
      const Image b = random_image(generator, 17, 9, kind);
      const Image black(17, 9, kind);
      CHECK(absolute_difference(a, b) == absolute_difference(b, a));
      CHECK(absolute_difference(a, a) == black);
      CHECK(absolute_difference(a, black) == a);
      CHECK(saturating_sum(a, b) == saturating_sum(b, a));
      CHECK(saturating_sum(a, black) == a);
      // The sum differs from one summand by the other, unless it has ended at 255.
      const Image sum = saturating_sum(a, b);
      const Image rest = absolute_difference(sum, a);
      for (std::size_t i = 0; i < a.bytes().size(); ++i)
        CHECK(rest.bytes()[i] == std::min<int>(b.bytes()[i], 255 - a.bytes()[i]));
      for (std::size_t i = 0; i < a.depths().size(); ++i)
        CHECK(sum.depths()[i] == a.depths()[i] + b.depths()[i]);
    }
  }
}

TEST_CASE("scaling rounds halves upwards and ends at 255") {
  Image image(4, 1, PixelKind::kGrey);
  image.row(0)[0] = 1;
  image.row(0)[1] = 2;
  image.row(0)[2] = 101;
  image.row(0)[3] = 200;
  const Image half = scaled(image, 0.5);
  CHECK(half.row(0)[0] == 1);
  CHECK(half.row(0)[1] == 1);
  CHECK(half.row(0)[2] == 51);
  CHECK(scaled(image, 2).row(0)[2] == 202);
  CHECK(scaled(image, 2).row(0)[3] == 255);
  CHECK(scaled(image, 1) == image);
  Image depth(1, 1, PixelKind::kDepth);
  depth.depth_row(0)[0] = 0.75F;
  CHECK(scaled(depth, 2).depth_row(0)[0] == 1.5F);
  CHECK(refusal_of([&] { scaled(image, -1); }) ==
        "`factor` of `scale` is -1; expected a number from 0 to 1000000.");
  CHECK_THROWS_AS(scaled(image, std::nan("")), ArgumentError);
}

TEST_CASE("a threshold leaves black and white, and is idempotent") {
  std::mt19937_64 generator(3);
  const Image image = random_image(generator, 64, 64, PixelKind::kGrey);
  const Image mask = threshold(image, 99);
  for (std::size_t i = 0; i < 64 * 64; ++i)
    CHECK(mask.bytes()[i] == (image.bytes()[i] >= 100 ? 255 : 0));
  CHECK(threshold(mask, 254) == mask);
  CHECK_THROWS_AS(threshold(image, 256), ArgumentError);
  CHECK_THROWS_AS(threshold(Image(2, 2, PixelKind::kDepth), 5), ArgumentError);
}

TEST_CASE("parts of pictures are where they were cut out") {
  std::mt19937_64 generator(4);
  for (const PixelKind kind : kKinds) {
    const Image image = random_image(generator, 20, 15, kind);
    CHECK(cropped(image, {0, 0, 20, 15}) == image);
    const Image part = cropped(image, {3, 4, 11, 15});
    CHECK(part.width() == 8);
    CHECK(part.height() == 11);
    CHECK(cropped(part, {2, 3, 5, 6}) == cropped(image, {5, 7, 8, 10}));
    for (int i = 0; i < part.channels(); ++i) {
      if (kind == PixelKind::kDepth) {
        CHECK(part.depth_row(2)[5] == image.depth_row(6)[8]);
      } else {
        CHECK(part.row(2)[5 * part.channels() + i] == image.row(6)[8 * part.channels() + i]);
      }
    }
    CHECK_THROWS_AS(cropped(image, {3, 4, 21, 15}), ArgumentError);
    CHECK_THROWS_AS(cropped(image, {3, 4, 3, 15}), ArgumentError);
    CHECK_THROWS_AS(cropped(image, {-1, 4, 3, 15}), ArgumentError);
  }
  CHECK(refusal_of([] {
          cropped(Image(4, 3, PixelKind::kGrey), {1, 2, 5, 3});
        }) == "The part 1 <= x < 5, 2 <= y < 3 is empty or leaves the picture of 4 x 3 pixels.");
}

TEST_CASE("pictures of different sizes or kinds are not combined") {
  CHECK(refusal_of([] {
          absolute_difference(Image(3, 2, PixelKind::kGrey), Image(3, 2, PixelKind::kRgb));
        }) ==
        "`absolute_difference` got pictures of 3 x 2 (grey) and 3 x 2 (RGB); expected the same "
        "size and kind.");
  CHECK_THROWS_AS(saturating_sum(Image(3, 2, PixelKind::kGrey), Image(2, 3, PixelKind::kGrey)),
                  ArgumentError);
  CHECK(saturating_sum(Image(), Image()).is_empty());
  CHECK_THROWS_AS(to_grey(Image(2, 2, PixelKind::kDepth)), ArgumentError);
}
