#include "armlet/vision/susan.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <sstream>
#include <string>

#include "armlet/core/error.hpp"
#include "refusal_of.hpp"
#include "vision/susan_rows.hpp"
#include "vision_reference.hpp"

using namespace armlet;

namespace {

Image painted(int width, int height, const std::function<int(int, int)>& brightness) {
  Image image(width, height, PixelKind::kGrey);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.row(y)[x] = static_cast<std::uint8_t>(brightness(x, y));
  return image;
}

// Overlapping rectangles and discs, edges of random contrast, a ramp and noise.
Image random_picture(std::mt19937_64& generator, int width, int height) {
  Image image = painted(width, height, [](int x, int y) { return (3 * x + 2 * y) / 8 % 256; });
  for (int shape = 0; shape < 12; ++shape) {
    const int x0 = static_cast<int>(generator() % width);
    const int y0 = static_cast<int>(generator() % height);
    const int size = 2 + static_cast<int>(generator() % 30);
    const int colour = static_cast<int>(generator() % 256);
    const bool is_round = generator() % 2 == 0;
    for (int y = std::max(0, y0 - size); y < std::min(height, y0 + size); ++y)
      for (int x = std::max(0, x0 - size); x < std::min(width, x0 + size); ++x)
        if (!is_round || (x - x0) * (x - x0) + (y - y0) * (y - y0) < size * size)
          image.row(y)[x] = static_cast<std::uint8_t>(colour);
  }
  const int noise = static_cast<int>(generator() % 20);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int value = image.row(y)[x] + static_cast<int>(generator() % (noise + 1));
      image.row(y)[x] = static_cast<std::uint8_t>(std::min(value, 255));
    }
  return image;
}

int area_at(const Image& image, int x, int y) {
  SusanTable table{};
  table.similarity[0] = 100;
  std::uint16_t area = 0;
  susan_row_scalar(image.row(y) + x, image.width(), 1, table, &area);
  return area;
}

}  // namespace

TEST_CASE("corners, responses and directions equal the lists of another detector") {
  int lists = 0;
  for (const std::string name : kReferencePictures) {
    const Image image = reference_picture(name);
    for (const int threshold : {10, 20, 40}) {
      CAPTURE(name);
      CAPTURE(threshold);
      std::ostringstream found;
      found << "x,y,response,dx,dy,intensity\n";
      for (const SusanCorner& c : susan_corners(image, {.threshold = threshold})) {
        const int n = 1850 - c.response;
        found << c.x << ',' << c.y << ',' << c.response << ',' << 51 * c.sum_x / n << ','
              << 51 * c.sum_y / n << ',' << c.brightness << '\n';
      }
      std::string expected =
          vision_reference("susan/" + name + "_t" + std::to_string(threshold) + ".csv");
      std::erase(expected, '\r');
      CHECK(found.str() == expected);
      ++lists;
    }
  }
  CHECK(lists == 18);
}

TEST_CASE("every instruction set finds the same corners at every threshold") {
  std::mt19937_64 generator(7);
  std::size_t corners = 0;
  for (int threshold = 1; threshold <= 255; ++threshold) {
    const int width = 11 + static_cast<int>(generator() % 250);
    const int height = 11 + static_cast<int>(generator() % 150);
    const Image image = random_picture(generator, width, height);
    CAPTURE(threshold);
    CAPTURE(width);
    const auto scalar = susan_corners(image, {threshold, InstructionSet::kBaseline});
    corners += scalar.size();
    if (is_supported(InstructionSet::kAvx2))
      CHECK(susan_corners(image, {threshold, InstructionSet::kAvx2}) == scalar);
    CHECK(susan_corners(image, {.threshold = threshold}) == scalar);
  }
  CHECK(corners > 2000);
}

TEST_CASE("the similarity of the formula is the one that the areas are summed from") {
  for (int threshold = 1; threshold <= 255; threshold += 2) {
    for (int d = 1; d < 256; d += 3) {
      const float u = std::pow(static_cast<float>(d) / static_cast<float>(threshold), 2.0F);
      const int c = static_cast<int>(static_cast<float>(100 * std::exp(-double{u * u * u})));
      // One pixel alone has n = 100 + 36 c; its centroid is itself, so it is never a corner.
      const Image spot = painted(13, 13, [&](int x, int y) { return x == 6 && y == 6 ? d : 0; });
      CHECK(susan_corners(spot, {.threshold = threshold}).empty());
      // A quarter: 13 pixels alike, 24 others; 9 of 13 remain a centroid that is far enough.
      const Image quarter = painted(15, 15, [&](int x, int y) { return x >= 7 && y >= 7 ? d : 0; });
      const auto corners = susan_corners(quarter, {.threshold = threshold});
      const auto tip = std::find_if(corners.begin(), corners.end(),
                                    [](const SusanCorner& s) { return s.x == 7 && s.y == 7; });
      if (tip != corners.end()) CHECK(tip->response == 1850 - 1300 - 24 * c);
      if (c == 0) CHECK(tip != corners.end());
    }
  }
}

TEST_CASE("areas of ideal shapes") {
  const auto area = [](const std::function<bool(int, int)>& is_bright) {
    return area_at(painted(9, 9, [&](int x, int y) { return is_bright(x - 4, y - 4) ? 200 : 50; }),
                   4, 4);
  };
  // Sums end early from 1850 on, in whole rows: straight edges and reflex corners are above that.
  CHECK(area([](int, int) { return true; }) >= 1850);
  CHECK(area([](int x, int) { return x >= 0; }) >= 1850);
  CHECK(area([](int x, int y) { return x + y >= 0; }) >= 1850);
  CHECK(area([](int x, int y) { return !(x < 0 && y < 0); }) >= 1850);
  CHECK(area([](int x, int y) { return x >= 0 && y >= 0; }) == 1300);
  CHECK(area([](int x, int y) { return y >= std::abs(x); }) == 1200);
  CHECK(area([](int, int y) { return y == 0; }) == 700);
  CHECK(area([](int x, int y) { return x == 0 && y == 0; }) == 100);
}

TEST_CASE("edges, lines, flat pictures and small pictures have no corners") {
  CHECK(susan_corners(painted(40, 30, [](int, int) { return 77; })).empty());
  CHECK(susan_corners(painted(40, 30, [](int x, int) { return x < 20 ? 0 : 200; })).empty());
  CHECK(susan_corners(painted(40, 40, [](int x, int y) { return x < y ? 0 : 200; })).empty());
  CHECK(susan_corners(painted(40, 30, [](int x, int) { return x == 20 ? 200 : 0; })).empty());
  CHECK(susan_corners(painted(1, 1, [](int, int) { return 9; })).empty());
  CHECK(susan_corners(painted(10, 300, [](int x, int y) { return 31 * x * y % 256; })).empty());
  CHECK(susan_corners(painted(300, 10, [](int x, int y) { return 31 * x * y % 256; })).empty());
}

TEST_CASE("a shifted or mirrored picture has shifted corners") {
  std::mt19937_64 generator(11);
  for (int round = 0; round < 30; ++round) {
    const Image image = random_picture(generator, 90, 70);
    const Image shifted =
        painted(90, 70, [&](int x, int y) { return x < 9 || y < 4 ? 0 : image.row(y - 4)[x - 9]; });
    std::vector<SusanCorner> wanted;
    for (SusanCorner c : susan_corners(image)) {
      c.x += 9;
      c.y += 4;
      if (c.x < 76 && c.y < 56) wanted.push_back(c);
    }
    std::vector<SusanCorner> found;
    for (const SusanCorner& c : susan_corners(shifted))
      if (c.x >= 9 + 14 && c.y >= 4 + 14 && c.x < 76 && c.y < 56) found.push_back(c);
    std::erase_if(wanted, [](const SusanCorner& c) { return c.x < 9 + 14 || c.y < 4 + 14; });
    CHECK(found == wanted);
    // The negative has the same differences and therefore the same corners.
    const Image negative = painted(90, 70, [&](int x, int y) { return 255 - image.row(y)[x]; });
    const auto a = susan_corners(image);
    const auto b = susan_corners(negative);
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      CHECK(a[i].response == b[i].response);
      CHECK(a[i].sum_x == b[i].sum_x);
      CHECK(a[i].brightness == 255 - b[i].brightness);
    }
  }
}

TEST_CASE("wrong arguments are refused in words") {
  const Image grey(20, 20, PixelKind::kGrey);
  CHECK(refusal_of([&] { susan_corners(grey, {.threshold = 0}); }) ==
        "`threshold` of `corners` is 0; expected a whole number from 1 to 255 grey levels.");
  CHECK(refusal_of([&] { susan_corners(Image(20, 20, PixelKind::kRgb)); }) ==
        "`susan_corners` takes a grey picture, not one of red, green and blue.");
  CHECK(refusal_of([&] { susan_corners(Image()); }) ==
        "`susan_corners` got a picture of 0 x 0 pixels; expected at least 1 x 1.");
}
