#include "armlet/camera/colors.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string>
#include <utility>

using namespace armlet;

// Rows of the table of CSS Color Module Level 4 (named colours), where names of X11 differ, and
// others.
TEST_CASE("names and codes of colours have the values of CSS") {
  constexpr auto kRows = std::to_array<std::pair<const char*, std::array<std::uint8_t, 3>>>({
      {"gray", {128, 128, 128}},
      {"green", {0, 128, 0}},
      {"maroon", {128, 0, 0}},
      {"purple", {128, 0, 128}},
      {"rebeccapurple", {102, 51, 153}},
      {"darkgrey", {169, 169, 169}},
      {"lightgoldenrodyellow", {250, 250, 210}},
      {"SteelBlue", {70, 130, 180}},
      {"tomato", {255, 99, 71}},
      {"yellowgreen", {154, 205, 50}},
      {"#0072b2", {0, 114, 178}},
  });
  for (const auto& [name, rgb] : kRows) {
    const std::string color(name);
    CAPTURE(color);
    CHECK(color_named(name) == linear_rgb(rgb[0], rgb[1], rgb[2]));
  }
}

TEST_CASE("other words are no colours") {
  for (const char* word : {"", "#", "#12345", "#12345g", "bleu", "red "}) {
    CAPTURE(word);
    CHECK_FALSE(color_named(word).has_value());
  }
}
