#include "armlet/vision/harris.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <tuple>

#include "armlet/core/error.hpp"
#include "random_image.hpp"
#include "refusal_of.hpp"
#include "vision_reference.hpp"

using namespace armlet;

namespace {

// Rows x, y, response of a list of OpenCV's, in the order of rows of the picture.
std::vector<HarrisCorner> reference_list(const std::string& name) {
  std::istringstream file(vision_reference(name + "_harris.csv"));
  std::string line;
  std::getline(file, line);
  std::vector<HarrisCorner> corners;
  char comma = ',';
  while (std::getline(file, line)) {
    HarrisCorner corner;
    std::istringstream(line) >> corner.x >> comma >> corner.y >> comma >> corner.response;
    corners.push_back(corner);
  }
  return corners;
}

void sort_by_position(std::vector<HarrisCorner>& corners) {
  std::sort(corners.begin(), corners.end(), [](const HarrisCorner& a, const HarrisCorner& b) {
    return std::tuple(a.y, a.x) < std::tuple(b.y, b.x);
  });
}

Image mirrored(const Image& image) {
  Image result(image.width(), image.height(), PixelKind::kGrey);
  for (int y = 0; y < image.height(); ++y)
    std::reverse_copy(image.row(y), image.row(y) + image.width(), result.row(y));
  return result;
}

}  // namespace

TEST_CASE("corners and responses equal those of OpenCV") {
  for (const std::string name : kReferencePictures) {
    CAPTURE(name);
    std::vector<HarrisCorner> found = harris_corners(reference_picture(name));
    CHECK(std::is_sorted(found.begin(), found.end(),
                         [](const auto& a, const auto& b) { return a.response > b.response; }));
    std::vector<HarrisCorner> wanted = reference_list(name);
    REQUIRE(found.size() == wanted.size());
    for (const HarrisCorner& other : wanted) {
      // The pixels around a crossing of the checkerboard are equally strong, and OpenCV takes the
      // last of them. It computes in single precision.
      const double reach = name == "checkerboard" ? 1.5 : 0.0;
      CAPTURE(other.x);
      CAPTURE(other.y);
      CHECK(std::count_if(found.begin(), found.end(), [&](const HarrisCorner& own) {
              return std::hypot(own.x - other.x, own.y - other.y) <= reach &&
                     std::abs(own.response - other.response) < 1e-4 * other.response;
            }) == 1);
    }
  }
}

TEST_CASE("the response of a corner of an ideal step is the one worked out by hand") {
  // A bright quarter, step h: with u = h / 255 the gradients are u / 3060 * 255 times 1, 3, 4 in
  // the rows and columns next to the corner; k = 0 leaves the determinant.
  Image image(12, 12, PixelKind::kGrey);
  for (int y = 6; y < 12; ++y) std::fill_n(image.row(y) + 6, 6, std::uint8_t{200});
  const auto corners = harris_corners(image, {.distance = 0, .sensitivity = 0});
  REQUIRE(!corners.empty());
  // At (6, 6): gx = h (1 3 4; 1 3 4; 0 0 0)' by rows y = 5, 6, 7 and columns 5, 6, 7, gy its
  // transpose: gx = 200 * [[1,1,0],[3,3,0],[4,4,0]].
  const double s = 200.0 / 3060.0;
  const double xx = s * s * 2 * (1 + 9 + 16);
  const double xy = s * s * (1 * 1 + 1 * 3 + 3 * 1 + 3 * 3);
  const auto tip = std::find_if(corners.begin(), corners.end(),
                                [](const HarrisCorner& c) { return c.x == 6 && c.y == 6; });
  REQUIRE(tip != corners.end());
  CHECK(tip->response == doctest::Approx(xx * xx - xy * xy).epsilon(1e-12));
}

TEST_CASE("corners keep their distance, and the strongest ones stay") {
  std::mt19937_64 generator(3);
  for (int round = 0; round < 20; ++round) {
    const Image image = random_image(generator, 80, 60, PixelKind::kGrey);
    const double distance = static_cast<double>(generator() % 20);
    const auto all = harris_corners(image, {.distance = 0});
    const auto kept = harris_corners(image, {.distance = distance});
    CHECK(kept.size() <= all.size());
    const auto near = [&](const HarrisCorner& a, const HarrisCorner& b) {
      return std::hypot(a.x - b.x, a.y - b.y) < distance;
    };
    std::size_t next = 0;
    // What the rule says, corner after corner.
    std::vector<HarrisCorner> wanted;
    for (const HarrisCorner& corner : all) {
      if (std::any_of(wanted.begin(), wanted.end(),
                      [&](const HarrisCorner& other) { return near(corner, other); }))
        continue;
      wanted.push_back(corner);
      REQUIRE(next < kept.size());
      CHECK(kept[next].x == corner.x);
      CHECK(kept[next].y == corner.y);
      ++next;
    }
    CHECK(next == kept.size());
    const auto few = harris_corners(image, {.distance = distance, .max = 3});
    REQUIRE(few.size() == std::min<std::size_t>(3, kept.size()));
    for (std::size_t i = 0; i < few.size(); ++i) CHECK(few[i].x == kept[i].x);
  }
}

TEST_CASE("mirrored pictures have mirrored corners; flat pictures and edges have none") {
  std::mt19937_64 generator(4);
  const Image image = random_image(generator, 61, 40, PixelKind::kGrey);
  auto a = harris_corners(image, {.distance = 0});
  auto b = harris_corners(mirrored(image), {.distance = 0});
  for (HarrisCorner& corner : b) corner.x = 60 - corner.x;
  sort_by_position(a);
  sort_by_position(b);
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].x == b[i].x);
    CHECK(a[i].response == b[i].response);
  }
  Image edge(30, 20, PixelKind::kGrey);
  CHECK(harris_corners(edge).empty());
  for (int y = 0; y < 20; ++y) std::fill_n(edge.row(y), 13, std::uint8_t{255});
  CHECK(harris_corners(edge).empty());
  for (const int side : {1, 2, 3})
    CHECK(harris_corners(Image(side, 4 - side, PixelKind::kGrey)).empty());
}

TEST_CASE("options out of range are refused in words") {
  const Image grey(20, 20, PixelKind::kGrey);
  CHECK(refusal_of([&] { harris_corners(grey, {.quality = 2}); }) ==
        "`quality` of `corners` is 2; expected a number from 0 to 1.");
  CHECK(refusal_of([&] { harris_corners(grey, {.distance = std::nan("")}); }) ==
        "`distance` of `corners` is nan; expected a number from 0 to 8192 px.");
  CHECK_THROWS_AS(harris_corners(grey, {.sensitivity = 0.3}), ArgumentError);
  CHECK_THROWS_AS(harris_corners(grey, {.max = -1}), ArgumentError);
  CHECK_THROWS_AS(harris_corners(Image(9, 9, PixelKind::kRgb)), ArgumentError);
}
