#include "armlet/world/looks.hpp"

#include <doctest/doctest.h>

using namespace armlet;
using namespace std::string_literals;

TEST_CASE("colours are names of CSS in whatever case, or six digits") {
  for (const char* good : {"red", "SteelBlue", "rebeccapurple", "#00ff7F"}) CHECK(is_color(good));
  for (const char* bad : {"", "rad", "#fff", "#00ff7g", "#00ff7f0", "rgb(1,2,3)"})
    CHECK_FALSE(is_color(bad));
  CHECK(similar_color("stealblue") == "steelblue");
  CHECK_FALSE(similar_color("qqqqqqqqq"));
}

namespace {

std::string png(unsigned width, unsigned height) {
  std::string bytes = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR"s;
  for (const unsigned side : {width, height})
    for (int k = 3; k >= 0; --k) bytes += static_cast<char>(side >> (8 * k) & 0xffU);
  return bytes + "\x08\x02\0\0\0****\0\0\0\0IEND****"s;
}

std::string jpeg(unsigned width, unsigned height) {
  std::string bytes = "\xff\xd8\xff\xe0\0\x04\0\0\xff\xc0\0\x0b\x08"s;
  for (const unsigned side : {height, width}) {
    bytes += static_cast<char>(side >> 8U);
    bytes += static_cast<char>(side & 0xffU);
  }
  return bytes + "\x01\x01\x11\0\xff\xd9"s;
}

}  // namespace

TEST_CASE(
    "pictures are looked at no further than their sizes, and whatever is cut off is refused") {
  CHECK(picture_fault(png(640, 480)).empty());
  CHECK(picture_fault(jpeg(640, 480)).empty());
  CHECK(picture_fault(png(8193, 1)) ==
        "it has 8193 x 1 pixels; expected 1 to 8192 in each direction");
  CHECK(picture_fault(png(0xffffffff, 2)).starts_with("it has 4294967295 x 2 pixels"));
  CHECK(picture_fault(jpeg(0, 5)).starts_with("it has 0 x 5 pixels"));
  CHECK(picture_fault(jpeg(9000, 5)).starts_with("it has 9000 x 5 pixels"));
  CHECK(picture_fault("GIF89a") == "it is neither a PNG nor a JPEG picture");
  for (std::size_t size = 0; size < png(4, 4).size(); ++size)
    CHECK_FALSE(picture_fault(png(4, 4).substr(0, size)).empty());
  for (std::size_t size = 0; size < 17; ++size)
    CHECK_FALSE(picture_fault(jpeg(4, 4).substr(0, size)).empty());
}
