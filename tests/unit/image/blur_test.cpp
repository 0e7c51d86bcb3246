#include "armlet/image/blur.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "random_image.hpp"
#include "refusal_of.hpp"

using namespace armlet;

namespace {

int value_at(const Image& image, int x, int y, int channel) {
  x = std::clamp(x, 0, image.width() - 1);
  y = std::clamp(y, 0, image.height() - 1);
  return image.row(y)[x * image.channels() + channel];
}

// The largest difference from the mean with weights that are products of those of x and y.
template <class Weight>
double worst_difference(const Image& image, const Image& blurred, int radius, Weight weight) {
  double worst = 0.0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < image.channels(); ++c) {
        double sum = 0.0;
        double total = 0.0;
        for (int dy = -radius; dy <= radius; ++dy)
          for (int dx = -radius; dx <= radius; ++dx) {
            const double w = weight(dx) * weight(dy);
            sum += w * value_at(image, x + dx, y + dy, c);
            total += w;
          }
        worst = std::max(worst, std::abs(value_at(blurred, x, y, c) - sum / total));
      }
  return worst;
}

Image mirrored(const Image& image) {
  Image result(image.height(), image.width(), image.kind());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < image.channels(); ++c)
        result.row(x)[y * image.channels() + c] = image.row(y)[x * image.channels() + c];
  return result;
}

}  // namespace

TEST_CASE("box blur is the mean of the square to the nearest grey level") {
  std::mt19937_64 generator(1);
  for (const PixelKind kind : {PixelKind::kGrey, PixelKind::kRgb}) {
    for (const int radius : {0, 1, 2, 7, 30}) {
      const Image image = random_image(generator, 23, 11, kind);
      const Image blurred = box_blurred(image, radius);
      CHECK(worst_difference(image, blurred, radius, [](int) { return 1.0; }) <= 0.5 + 1e-9);
      CHECK(box_blurred(mirrored(image), radius) == mirrored(blurred));
    }
  }
}

TEST_CASE("Gaussian blur is the mean with the weights of the bell") {
  std::mt19937_64 generator(2);
  for (const PixelKind kind : {PixelKind::kGrey, PixelKind::kRgb}) {
    for (const double sigma : {0.25, 0.7, 1.0, 2.3, 6.0}) {
      const Image image = random_image(generator, 25, 14, kind);
      const int radius = static_cast<int>(std::ceil(3 * sigma));
      const double worst =
          worst_difference(image, gaussian_blurred(image, sigma), radius,
                           [&](int d) { return std::exp(-d * d / (2 * sigma * sigma)); });
      CAPTURE(sigma);
      // Half a grey level of rounding, 2^-9 of rows, and weights that are off by up to 2^-17.
      CHECK(worst <= 0.5 + 0.002 + 255.0 * 4 * radius * 0x1p-17);
    }
    CHECK(gaussian_blurred(random_image(generator, 5, 5, kind), 0.0).width() == 5);
  }
}

TEST_CASE("flat pictures stay as they are, and spots keep their light") {
  for (const double sigma : {0.1, 0.5, 1.0, 3.0, 10.0, 30.0}) {
    Image flat(31, 7, PixelKind::kGrey);
    for (int y = 0; y < 7; ++y) std::fill_n(flat.row(y), 31, std::uint8_t{255});
    CHECK(gaussian_blurred(flat, sigma) == flat);
    CHECK(box_blurred(flat, 5) == flat);
  }
  // A square of 20 x 20 in the dark: the sum of all pixels does not change but for rounding.
  Image square(80, 80, PixelKind::kGrey);
  for (int y = 30; y < 50; ++y) std::fill_n(square.row(y) + 30, 20, std::uint8_t{240});
  long sum = 0;
  const Image blurred = gaussian_blurred(square, 2.0);
  for (const std::uint8_t value : blurred.bytes()) sum += value;
  CHECK(std::abs(sum - 240 * 400) < 240 * 4);
}

TEST_CASE("sizes and arguments out of range are refused in words") {
  CHECK(refusal_of([] { gaussian_blurred(Image(3, 3, PixelKind::kGrey), 31); }) ==
        "`sigma` of `blur` is 31; expected a number from 0 to 30 px.");
  CHECK(refusal_of([] { box_blurred(Image(3, 3, PixelKind::kGrey), 101); }) ==
        "`radius` of `boxBlur` is 101; expected a whole number from 0 to 100 px.");
  CHECK_THROWS_AS(gaussian_blurred(Image(3, 3, PixelKind::kDepth), 1), ArgumentError);
  CHECK_THROWS_AS(box_blurred(Image(), 1), ArgumentError);
}
