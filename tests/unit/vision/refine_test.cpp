#include "armlet/vision/refine.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <string>

#include "armlet/core/error.hpp"
#include "refusal_of.hpp"
#include "uniform.hpp"
#include "vision_reference.hpp"

using namespace armlet;

namespace {

// A bright wedge with its tip at (x, y) and its sides in the directions a and b, drawn with 16 x 16
// samples per pixel.
Image wedge(double x, double y, double a, double b) {
  Image image(41, 41, PixelKind::kGrey);
  for (int row = 0; row < 41; ++row)
    for (int column = 0; column < 41; ++column) {
      int inside = 0;
      for (int i = 0; i < 256; ++i) {
        const double dx = column + (i % 16 + 0.5) / 16 - 0.5 - x;
        const double dy = row + (i / 16 + 0.5) / 16 - 0.5 - y;
        inside +=
            std::cos(a) * dy - std::sin(a) * dx > 0 && std::sin(b) * dx - std::cos(b) * dy > 0;
      }
      image.row(row)[column] = static_cast<std::uint8_t>(std::lround(30 + 200.0 * inside / 256));
    }
  return image;
}

PlanePoints point(double x, double y) {
  PlanePoints points(1, 2);
  points << x, y;
  return points;
}

}  // namespace

TEST_CASE("refined corners equal those of OpenCV") {
  for (const std::string name : kReferencePictures) {
    std::istringstream file(vision_reference(name + "_harris.csv"));
    std::string line;
    std::getline(file, line);
    const Image image = reference_picture(name);
    char comma = ',';
    while (std::getline(file, line)) {
      double x0 = 0, y0 = 0, response = 0, x = 0, y = 0;
      std::istringstream(line) >> x0 >> comma >> y0 >> comma >> response >> comma >> x >> comma >>
          y;
      const RefinedCorner corner = refine_corners(image, point(x0, y0)).front();
      CAPTURE(name);
      CAPTURE(x0);
      CAPTURE(y0);
      CHECK(corner.end != RefineEnd::kLeft);
      // Both stop when a step is shorter than 0.001 px, but OpenCV counts in floats and stops early
      // where rounding hides the last steps.
      CHECK(std::hypot(corner.x - x, corner.y - y) < 0.05);
    }
  }
}

TEST_CASE("tips of wedges are found to a fraction of a pixel from starts two pixels away") {
  std::mt19937_64 generator(1);
  double squares = 0.0;
  int count = 0;
  for (int round = 0; round < 200; ++round) {
    const double x = uniform(generator, 18, 22);
    const double y = uniform(generator, 18, 22);
    const double a = uniform(generator, -3.1, 3.1);
    const Image image = wedge(x, y, a, a + uniform(generator, 1.3, 1.9));
    const PlanePoints start =
        point(x + uniform(generator, -1.4, 1.4), y + uniform(generator, -1.4, 1.4));
    const RefinedCorner corner = refine_corners(image, start).front();
    CHECK(corner.end == RefineEnd::kConverged);
    const double error = std::hypot(corner.x - x, corner.y - y);
    CHECK(error < 0.5);
    squares += error * error;
    ++count;
    // The start matters no more than the precision.
    const RefinedCorner again = refine_corners(image, point(corner.x, corner.y)).front();
    CHECK(std::hypot(again.x - corner.x, again.y - corner.y) < 0.01);
  }
  // OpenCV's search leaves 0.20 px for rendered squares: pixels average sharp edges.
  CHECK(std::sqrt(squares / count) < 0.22);
}

TEST_CASE("the crossing of a saddle is exact by symmetry") {
  // Brightness that is odd about the point (20, 20) along both axes.
  Image image(41, 41, PixelKind::kGrey);
  for (int y = 0; y < 41; ++y)
    for (int x = 0; x < 41; ++x)
      image.row(y)[x] =
          static_cast<std::uint8_t>(x == 20 || y == 20 ? 100 : ((x < 20) == (y < 20) ? 50 : 150));
  for (const double dx : {-2.0, -0.5, 0.0, 1.5}) {
    const RefinedCorner corner =
        refine_corners(image, point(20 + dx, 20 - dx / 2), {.precision = 1e-9}).front();
    CHECK(corner.x == doctest::Approx(20).epsilon(1e-7));
    CHECK(corner.y == doctest::Approx(20).epsilon(1e-7));
  }
}

TEST_CASE("flat windows, edges and far corners are reported") {
  Image image(40, 40, PixelKind::kGrey);
  CHECK(refine_corners(image, point(20, 20)).front().end == RefineEnd::kNoCorner);
  for (int y = 0; y < 40; ++y) std::fill_n(image.row(y), 20, std::uint8_t{200});
  const RefinedCorner edge = refine_corners(image, point(20, 20)).front();
  CHECK(edge.end == RefineEnd::kNoCorner);
  CHECK(edge.x == 20);
  // The sides of a narrow wedge meet 9 px above the start.
  const Image narrow = wedge(20, 5, 1.42, 1.72);
  const RefinedCorner left = refine_corners(narrow, point(20, 14), {.window = 4}).front();
  CHECK(left.end == RefineEnd::kLeft);
  CHECK(left.x == 20);
  CHECK(left.y == 14);
  const Image wide = wedge(20, 20, 1.0, 2.5);
  CHECK(refine_corners(wide, point(19, 21), {.iterations = 1}).front().end ==
        RefineEnd::kIterations);
  CHECK(refine_corners(wide, PlanePoints(0, 2)).empty());
}

TEST_CASE("starts outside and options out of range are refused in words") {
  const Image image(40, 30, PixelKind::kGrey);
  CHECK(refusal_of([&] { refine_corners(image, point(3, 30)); }) ==
        "Corner 1 at (3, 30) px is outside the picture of 40 x 30 pixels.");
  CHECK_THROWS_AS(refine_corners(image, point(std::nan(""), 3)), ArgumentError);
  CHECK_THROWS_AS(refine_corners(image, point(1e300, 3)), ArgumentError);
  CHECK(refusal_of([&] { refine_corners(image, point(3, 3), {.window = 0}); }) ==
        "`window` of `refineCorners` is 0; expected a whole number from 1 to 50 px.");
  CHECK_THROWS_AS(refine_corners(image, point(3, 3), {.precision = -1}), ArgumentError);
  CHECK_THROWS_AS(refine_corners(Image(9, 9, PixelKind::kRgb), point(3, 3)), ArgumentError);
}
