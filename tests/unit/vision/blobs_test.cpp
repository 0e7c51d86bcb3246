#include "armlet/vision/blobs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "armlet/core/error.hpp"
#include "random_image.hpp"
#include "refusal_of.hpp"
#include "uniform.hpp"

using namespace armlet;

namespace {

Image mask_of(int width, int height, const std::function<bool(double, double)>& is_inside) {
  Image mask(width, height, PixelKind::kGrey);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) mask.row(y)[x] = is_inside(x, y) ? 1 : 0;
  return mask;
}

Image drawn(const std::vector<std::string>& rows) {
  return mask_of(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()),
                 [&](double x, double y) {
                   return rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#';
                 });
}

// Area, mean x and mean y of each region, found by flooding from each first pixel.
std::vector<std::array<double, 3>> flooded(Image mask, bool at_corners) {
  std::vector<std::array<double, 3>> regions;
  for (int y0 = 0; y0 < mask.height(); ++y0)
    for (int x0 = 0; x0 < mask.width(); ++x0) {
      if (mask.row(y0)[x0] == 0) continue;
      std::vector<std::pair<int, int>> open{{x0, y0}};
      mask.row(y0)[x0] = 0;
      double n = 0, sum_x = 0, sum_y = 0;
      while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        ++n;
        sum_x += x;
        sum_y += y;
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            if (!at_corners && dx != 0 && dy != 0) continue;
            const int x1 = x + dx, y1 = y + dy;
            if (x1 < 0 || y1 < 0 || x1 >= mask.width() || y1 >= mask.height()) continue;
            if (mask.row(y1)[x1] == 0) continue;
            mask.row(y1)[x1] = 0;
            open.emplace_back(x1, y1);
          }
      }
      regions.push_back({n, sum_x / n, sum_y / n});
    }
  return regions;
}

}  // namespace

TEST_CASE("regions are those that flooding finds, in the order of their first pixels") {
  std::mt19937_64 generator(1);
  for (int round = 0; round < 300; ++round) {
    const int width = 1 + static_cast<int>(generator() % 40);
    const int height = 1 + static_cast<int>(generator() % 40);
    const double share = uniform(generator, 0.1, 0.9);
    const Image mask =
        mask_of(width, height, [&](double, double) { return uniform(generator, 0, 1) < share; });
    for (const Touching touching : {Touching::kSides, Touching::kCorners}) {
      const auto blobs = find_blobs(mask, mask, {.min_area = 1, .touching = touching});
      const auto wanted = flooded(mask, touching == Touching::kCorners);
      REQUIRE(blobs.size() == wanted.size());
      for (std::size_t i = 0; i < blobs.size(); ++i) {
        CHECK(blobs[i].area == wanted[i][0]);
        CHECK(blobs[i].x == doctest::Approx(wanted[i][1]).epsilon(1e-12));
        CHECK(blobs[i].y == doctest::Approx(wanted[i][2]).epsilon(1e-12));
      }
    }
  }
}

TEST_CASE("spirals, combs and rings are one region; diagonals depend on what touches") {
  const Image spiral = drawn(
      {"#########", "#.......#", "#.#####.#", "#.#...#.#", "#.#.###.#", "#.#.....#", "#.#######"});
  CHECK(find_blobs(spiral, spiral, {.min_area = 1, .touching = Touching::kSides}).size() == 1);
  const Image comb = drawn({"#.#.#.#", "#.#.#.#", "#######"});
  CHECK(find_blobs(comb, comb, {.min_area = 1}).size() == 1);
  const Image diagonal = drawn({"#..", ".#.", "..#"});
  CHECK(find_blobs(diagonal, diagonal, {.min_area = 1}).size() == 1);
  CHECK(find_blobs(diagonal, diagonal, {.min_area = 1, .touching = Touching::kSides}).size() == 3);
  const Image ring = drawn({"####", "#..#", "#..#", "####"});
  const auto blobs = find_blobs(ring, ring, {.min_area = 12});
  REQUIRE(blobs.size() == 1);
  CHECK(blobs[0].area == 12);
  CHECK(blobs[0].x == 1.5);
  CHECK(find_blobs(ring, ring, {.min_area = 13}).empty());
}

TEST_CASE("upright rectangles have their sides exactly, wherever they are") {
  std::mt19937_64 generator(2);
  for (int round = 0; round < 100; ++round) {
    const int w = 1 + static_cast<int>(generator() % 60);
    const int h = 1 + static_cast<int>(generator() % 60);
    const int x0 = static_cast<int>(generator() % 40);
    const int y0 = static_cast<int>(generator() % 40);
    const Image mask = mask_of(100, 100, [&](double x, double y) {
      return x >= x0 && x < x0 + w && y >= y0 && y < y0 + h;
    });
    const Blob blob = find_blobs(mask, mask, {.min_area = 1}).front();
    CHECK(blob.area == w * h);
    CHECK(blob.x == x0 + (w - 1) / 2.0);
    CHECK(blob.width == doctest::Approx(std::max(w, h)).epsilon(1e-9));
    CHECK(blob.height == doctest::Approx(std::min(w, h)).epsilon(1e-9));
    CHECK(blob.angle == doctest::Approx(w >= h ? 0.0 : std::numbers::pi / 2).epsilon(1e-9));
    CHECK(blob.box == PixelBox{x0, y0, x0 + w, y0 + h});
  }
}

TEST_CASE("rotated rectangles have their angle and sides, ellipses the ones of theory") {
  std::mt19937_64 generator(3);
  for (int round = 0; round < 60; ++round) {
    const double angle = uniform(generator, -1.57, 1.57);
    const double a = uniform(generator, 40, 60);
    const double b = uniform(generator, 15, 30);
    const double x0 = uniform(generator, 55, 65);
    const double y0 = uniform(generator, 55, 65);
    const auto local = [&](double x, double y) {
      return std::pair(std::cos(angle) * (x - x0) + std::sin(angle) * (y - y0),
                       std::cos(angle) * (y - y0) - std::sin(angle) * (x - x0));
    };
    const Image box = mask_of(120, 120, [&](double x, double y) {
      const auto [u, v] = local(x, y);
      return std::abs(u) < a / 2 && std::abs(v) < b / 2;
    });
    const Image ellipse = mask_of(120, 120, [&](double x, double y) {
      const auto [u, v] = local(x, y);
      return u * u / (a * a) + v * v / (b * b) < 0.25;
    });
    // An ellipse with the axes a and b has the moments a^2 / 16 and b^2 / 16.
    for (const auto& [mask, factor] :
         {std::pair(&box, 1.0), std::pair(&ellipse, std::sqrt(12.0 / 16.0))}) {
      const Blob blob = find_blobs(*mask, *mask).front();
      // Steps of pixels along the border: half a pixel of the centre, a percent or two of sides.
      CHECK(std::abs(blob.x - x0) < 0.5);
      CHECK(std::abs(blob.y - y0) < 0.5);
      CHECK(std::abs(std::remainder(blob.angle - angle, std::numbers::pi)) < 0.03);
      CHECK(std::abs(blob.width - factor * a) < 0.8);
      CHECK(std::abs(blob.height - factor * b) < 0.8);
    }
  }
}

TEST_CASE("large coordinates lose no digits") {
  Image mask(Image::kMostSide, 40, PixelKind::kGrey);
  for (int y = 30; y < 33; ++y) std::fill_n(mask.row(y) + 8100, 7, std::uint8_t{255});
  const Blob blob = find_blobs(mask, mask).front();
  CHECK(blob.width == doctest::Approx(7).epsilon(1e-12));
  CHECK(blob.height == doctest::Approx(3).epsilon(1e-12));
}

TEST_CASE("colours: the mean of a region, and the mask of a colour") {
  Image picture(20, 10, PixelKind::kRgb);
  for (int y = 2; y < 8; ++y)
    for (int x = 3; x < 9; ++x) {
      picture.row(y)[3 * x] = static_cast<std::uint8_t>(x % 2 == 0 ? 200 : 180);
      picture.row(y)[3 * x + 1] = 40;
      picture.row(y)[3 * x + 2] = 10;
    }
  const Image mask = color_mask(picture, {190, 40, 10}, 10);
  const auto blobs = find_blobs(mask, picture);
  REQUIRE(blobs.size() == 1);
  CHECK(blobs[0].area == 36);
  CHECK(blobs[0].color[0] == 190);
  CHECK(blobs[0].color[1] == 40);
  CHECK(blobs[0].color[2] == 10);
  CHECK(find_blobs(color_mask(picture, {190, 40, 10}, 9), picture).empty());
  CHECK(find_blobs(mask, to_grey(picture)).front().color[2] ==
        find_blobs(mask, to_grey(picture)).front().color[0]);
}

TEST_CASE("wrong arguments are refused in words") {
  const Image mask(20, 10, PixelKind::kGrey);
  CHECK(find_blobs(mask, mask).empty());
  CHECK(refusal_of([&] { find_blobs(mask, Image(20, 11, PixelKind::kRgb)); }) ==
        "`find_blobs` got a mask of 20 x 10 pixels and a picture of 20 x 11; expected the same "
        "size.");
  CHECK(refusal_of([&] { find_blobs(mask, mask, {.min_area = 0}); }) ==
        "`minArea` of `blobs` is 0; expected a whole number from 1 to 67108864 px.");
  CHECK_THROWS_AS(find_blobs(Image(2, 2, PixelKind::kRgb), mask), ArgumentError);
  CHECK_THROWS_AS(color_mask(mask, {1, 2, 3}, 256), ArgumentError);
}
