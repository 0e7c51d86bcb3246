#include "armlet/image/noise.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "armlet/core/error.hpp"
#include "refusal_of.hpp"

using namespace armlet;

namespace {

Image flat(int value) {
  Image image(1000, 300, PixelKind::kGrey);
  for (int y = 0; y < image.height(); ++y)
    std::fill_n(image.row(y), 1000, static_cast<std::uint8_t>(value));
  return image;
}

}  // namespace

TEST_CASE("noise has the distribution of the normal law") {
  for (const double sigma : {2.0, 8.0, 20.0}) {
    Image image = flat(128);
    Random random(1);
    add_noise(image, sigma, random);
    std::vector<double> count(256);
    for (const std::uint8_t value : image.bytes()) ++count[value];
    double mean = 0.0;
    double square = 0.0;
    double below = 0.0;
    double worst = 0.0;
    const double n = static_cast<double>(image.bytes().size());
    for (int v = 0; v < 256; ++v) {
      const double share = count[static_cast<std::size_t>(v)] / n;
      mean += share * (v - 128);
      square += share * (v - 128) * (v - 128);
      below += share;
      const double law = 0.5 * std::erfc(-(v - 128 + 0.5) / sigma * std::sqrt(0.5));
      worst = std::max(worst, std::abs(below - law));
    }
    CAPTURE(sigma);
    // Five standard errors of 300,000 samples; rounding adds a variance of 1/12.
    CHECK(std::abs(mean) < 5 * sigma / std::sqrt(n));
    CHECK(std::abs(std::sqrt(square - 1.0 / 12) / sigma - 1) < 5 / std::sqrt(2 * n));
    CHECK(worst < 2.2 / std::sqrt(n));  // Kolmogorov and Smirnov, 1 in 10,000
  }
}

TEST_CASE("the farthest number is the last quantile") {
  // 1,200,000 samples hold the last quantile, 1 - 1 / 131072, which is 4.325 sigma (erfc(4.325 /
  // sqrt(2)) / 2 = 7.63e-6), 43 grey levels for a sigma of 10.
  Image image = flat(128);
  Random random(5);
  int most = 0;
  for (int round = 0; round < 4; ++round) {
    Image copy = image;
    add_noise(copy, 10.0, random);
    for (const std::uint8_t value : copy.bytes()) most = std::max<int>(most, value);
  }
  CHECK(most == 128 + 43);
}

TEST_CASE("the same seed gives the same noise, another seed another") {
  Image a = flat(100);
  Image b = a;
  Image c = a;
  Random one(7);
  Random same(7);
  Random other(8);
  add_noise(a, 5, one);
  add_noise(b, 5, same);
  add_noise(c, 5, other);
  CHECK(a == b);
  CHECK_FALSE(a == c);
  Image untouched = flat(100);
  add_noise(untouched, 0, one);
  CHECK(untouched == flat(100));
  Image dark = flat(0);
  add_noise(dark, 50, one);
  CHECK(*std::max_element(dark.bytes().begin(), dark.bytes().end()) > 150);
}

TEST_CASE("wrong arguments are refused in words") {
  Image depth(3, 3, PixelKind::kDepth);
  Image grey(3, 3, PixelKind::kGrey);
  Random random(1);
  CHECK_THROWS_AS(add_noise(depth, 1, random), ArgumentError);
  CHECK(refusal_of([&] { add_noise(grey, -1, random); }) ==
        "`sigma` of `noise` is -1; expected a number from 0 to 255 grey levels.");
}
