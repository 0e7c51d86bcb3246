#include "armlet/image/plain_png.hpp"

#include <doctest/doctest.h>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/image/files.hpp"

using namespace armlet;

namespace {

// Pixels in runs of equal bytes of random lengths, `longest` at most.
Image random_image(Random& random, int width, int height, PixelKind kind, int longest) {
  Image image(width, height, kind);
  int left = 0;
  std::uint8_t level = 0;
  for (int y = 0; y < height; ++y) {
    for (int i = 0; i < width * image.channels(); ++i) {
      if (left-- <= 0) {
        left = static_cast<int>(random.uniform() * longest);
        level = static_cast<std::uint8_t>(random.uniform() * 256.0);
      }
      image.row(y)[i] = level;
    }
  }
  return image;
}

}  // namespace

TEST_CASE("libpng and zlib read the same pixels, whatever they are") {
  Random random(5);
  for (const PixelKind kind : {PixelKind::kGrey, PixelKind::kRgb}) {
    for (const int longest : {0, 3, 40, 700}) {
      for (int k = 0; k < 40; ++k) {
        const int width = 1 + static_cast<int>(random.uniform() * 90.0);
        const int height = 1 + static_cast<int>(random.uniform() * 40.0);
        const Image image = random_image(random, width, height, kind, longest);
        const Result<Image> read = read_image(plain_png(image));
        REQUIRE(read.ok());
        CHECK(*read == image);
      }
    }
  }
}

TEST_CASE("runs of every length are read back") {
  for (int length = 1; length < 600; ++length) {
    Image image(length + 2, 1, PixelKind::kGrey);
    image.row(0)[0] = 200;
    image.row(0)[length + 1] = 100;
    const Result<Image> read = read_image(plain_png(image));
    REQUIRE(read.ok());
    CHECK(*read == image);
  }
}

TEST_CASE("what is drawn is short, and what is photographed not much longer than its pixels") {
  CHECK(plain_png(Image(640, 480, PixelKind::kRgb)).size() < 10'000);
  Random random(6);
  const Image noise = random_image(random, 640, 480, PixelKind::kRgb, 0);
  CHECK(plain_png(noise).size() < 1.1 * static_cast<double>(noise.bytes().size()));
}

TEST_CASE("depths and pictures without pixels are refused") {
  CHECK_THROWS_AS((void)plain_png(Image(2, 2, PixelKind::kDepth)), ArgumentError);
  CHECK_THROWS_AS((void)plain_png(Image()), ArgumentError);
}
