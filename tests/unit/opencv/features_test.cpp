// Edges, lines, circles, templates and corners that are known.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "armlet/core/random.hpp"
#include "armlet/image/blur.hpp"
#include "armlet/image/noise.hpp"
#include "armlet/vision/corners.hpp"
#include "armlet/vision/edges.hpp"
#include "armlet/vision/fast.hpp"
#include "armlet/vision/opencv.hpp"
#include "armlet/vision/template_match.hpp"
#include "refusal_of.hpp"

using namespace armlet;

namespace {

// A picture whose pixels are the shares of 4 x 4 points that lie in a region, from `dark` to
// `bright`.
template <class F>
Image drawn(int width, int height, int dark, int bright, F inside) {
  Image image(width, height, PixelKind::kGrey);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      int count = 0;
      for (int i = 0; i < 16; ++i)
        count += inside(x + (i % 4 - 1.5) / 4.0, y + (i / 4 - 1.5) / 4.0) ? 1 : 0;
      image.row(y)[x] = static_cast<std::uint8_t>(dark + (bright - dark) * count / 16);
    }
  }
  return image;
}

double random_between(Random& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

}  // namespace

TEST_CASE("OpenCV is there") { REQUIRE(has_opencv()); }

TEST_CASE("edges of a step are one pixel wide and lie on it") {
  const Image step = drawn(60, 40, 20, 220, [](double x, double) { return x > 29.5; });
  const Image edges = find_edges(step);
  for (int y = 2; y < 38; ++y) {
    int count = 0;
    for (int x = 0; x < 60; ++x) {
      if (edges.row(y)[x] == 0) continue;
      ++count;
      CHECK((x == 29 || x == 30));
    }
    CHECK(count == 1);
  }
  // Sobel's masks give 4 times the difference of 200.
  CHECK(std::ranges::count(find_edges(step, 700, 810).bytes(), 255) == 0);
  CHECK(std::ranges::count(find_edges(step, 700, 790).bytes(), 255) >= 38);
}

TEST_CASE("random half planes have a line along their border, within a pixel and 1.5 degrees") {
  Random random(7);
  for (int trial = 0; trial < 60; ++trial) {
    const double angle = random_between(random, 0.0, 2.0 * std::numbers::pi);
    const double nx = std::cos(angle), ny = std::sin(angle);
    const double d = random_between(random, -20.0, 20.0);
    const auto side = [&](double x, double y) { return nx * (x - 80) + ny * (y - 60) - d; };
    const Image picture =
        drawn(160, 120, 60, 180, [&](double x, double y) { return side(x, y) > 0.0; });
    const auto lines = find_lines(find_edges(picture));
    CAPTURE(angle);
    REQUIRE(lines.rows() >= 1);
    // Edges are at whole pixels, and 0.5 px towards the brighter side or not.
    CHECK(std::abs(side(lines(0, 0), lines(0, 1))) < 0.8);
    CHECK(std::abs(side(lines(0, 2), lines(0, 3))) < 0.8);
    CHECK((lines.row(0).head(2) - lines.row(0).tail(2)).norm() > 40.0);
    const double found = std::atan2(lines(0, 3) - lines(0, 1), lines(0, 2) - lines(0, 0));
    const double off = std::abs(std::sin(found - angle - 0.5 * std::numbers::pi));
    CHECK(off < 0.026);
  }
}

TEST_CASE("random discs are found within half a pixel, and nothing else is") {
  Random random(11);
  double sum = 0.0;
  for (int trial = 0; trial < 60; ++trial) {
    const double r = random_between(random, 10.0, 40.0);
    const double cx = random_between(random, 50.0, 110.0), cy = random_between(random, 50.0, 70.0);
    Image picture = drawn(160, 120, 50, 190,
                          [&](double x, double y) { return std::hypot(x - cx, y - cy) < r; });
    Random noise(trial);
    add_noise(picture, 3.0, noise);
    const auto circles = find_circles(picture);
    CAPTURE(r);
    REQUIRE(circles.rows() == 1);
    const double off = std::hypot(circles(0, 0) - cx, circles(0, 1) - cy);
    CHECK(off < 0.5);
    CHECK(std::abs(circles(0, 2) - r) < 0.8);
    sum += off * off;
  }
  CHECK(std::sqrt(sum / 60) < 0.25);
  CHECK(find_circles(Image(60, 40, PixelKind::kGrey)).rows() == 0);
}

TEST_CASE("a template is found where it was cut out, and between pixels") {
  Random random(5);
  Image noise(200, 150, PixelKind::kGrey);
  for (int y = 0; y < noise.height(); ++y) std::fill_n(noise.row(y), noise.width(), 128);
  add_noise(noise, 40.0, random);
  for (const auto& [x, y] : {std::pair{20, 30}, {150, 100}, {0, 0}}) {
    Image part(31, 21, PixelKind::kGrey);
    for (int row = 0; row < 21; ++row) std::copy_n(noise.row(y + row) + x, 31, part.row(row));
    const TemplateMatch found = match_template(noise, part);
    CHECK(std::abs(found.x - (x + 15)) < 0.1);
    CHECK(std::abs(found.y - (y + 10)) < 0.1);
    CHECK(found.score == doctest::Approx(1.0).epsilon(1e-4));
  }
  // A soft spot a third of a pixel further.
  const auto spot = [](double cx) {
    Image image(80, 60, PixelKind::kGrey);
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 80; ++x)
        image.row(y)[x] = static_cast<std::uint8_t>(
            std::lround(30 + 200 * std::exp(-(std::pow(x - cx, 2) + std::pow(y - 30, 2)) / 50)));
    return image;
  };
  const Image first = spot(40.0);
  Image part(25, 25, PixelKind::kGrey);
  for (int row = 0; row < 25; ++row) std::copy_n(first.row(18 + row) + 28, 25, part.row(row));
  CHECK(match_template(spot(44.3), part).x == doctest::Approx(44.3).epsilon(0.002));
}

TEST_CASE("corners by FAST surround a square, refined within half a pixel") {
  // Of equally strong neighbours it takes none, so that it misses corners of ideal squares.
  const Image square = gaussian_blurred(drawn(100, 80, 40, 200,
                                              [](double x, double y) {
                                                const double u = 0.96 * (x - 50) + 0.28 * (y - 40);
                                                const double v = -0.28 * (x - 50) + 0.96 * (y - 40);
                                                return std::abs(u) < 20 && std::abs(v) < 15;
                                              }),
                                        0.8);
  const PlanePoints found = find_corners(square, {.method = CornerMethod::kFast});
  REQUIRE(found.rows() >= 4);
  for (const auto& [u, v] : {std::pair{20, 15}, {20, -15}, {-20, -15}, {-20, 15}}) {
    const Eigen::RowVector2d corner(50 + 0.96 * u - 0.28 * v, 40 + 0.28 * u + 0.96 * v);
    CHECK((found.rowwise() - corner).rowwise().norm().minCoeff() < 0.5);
  }
  CHECK(fast_corners(square, 255).rows() == 0);
  CHECK(find_corners(square, {.method = CornerMethod::kFast, .max = 2}).rows() == 2);
}

TEST_CASE("wrong pictures and options are refused with numbers") {
  const Image grey(40, 30, PixelKind::kGrey), rgb(40, 30, PixelKind::kRgb);
  CHECK(refusal_of([&] { find_edges(rgb); }).find("grey") != std::string::npos);
  CHECK(refusal_of([&] { find_edges(grey, 200, 100); }) == "`low` of `edges` is above `high`.");
  CHECK(refusal_of([&] { find_edges(grey, -1, 100); }).find("from 0 to 1500") != std::string::npos);
  CHECK(refusal_of([&] {
          find_lines(drawn(40, 30, 0, 77, [](double x, double) { return x > 9; }));
        }).find("lines(edges(img))") != std::string::npos);
  CHECK(refusal_of([&] { match_template(grey, grey); }).find("one brightness") !=
        std::string::npos);
  CHECK(refusal_of([&] { match_template(grey, Image(50, 30, PixelKind::kGrey)); }) ==
        "The template has 50 x 30 pixels, more than the 40 x 30 of the picture.");
  CHECK(refusal_of([&] { find_edges(Image(4096, 2048, PixelKind::kGrey)); }) ==
        "`edges` takes pictures of 4194304 pixels at most, not 8388608.");
  Image noise(2048, 2048, PixelKind::kGrey);
  Random random(3);
  for (int y = 0; y < 2048; ++y) std::fill_n(noise.row(y), 2048, 128);
  add_noise(noise, 60.0, random);
  CHECK(refusal_of([&] { find_lines(find_edges(noise)); }).find("at most 50000") !=
        std::string::npos);
}
