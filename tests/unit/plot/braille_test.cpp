#include "armlet/plot/braille.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

using namespace armlet;

namespace {

Figure picture_of(int width, int height, PixelKind kind, std::uint8_t level) {
  Image image(width, height, kind);
  for (int y = 0; y < height; ++y) std::fill_n(image.row(y), width * image.channels(), level);
  return {.title = "seen", .picture = std::make_shared<const Image>(image), .note = "note"};
}

// The rows of a text, and how many letters the longest has.
std::pair<int, int> size_of(const std::string& text) {
  int rows = 0, widest = 0, letters = 0;
  for (const char c : text) {
    if (c == '\n') {
      ++rows;
      widest = std::max(widest, letters);
      letters = 0;
    } else if ((static_cast<unsigned char>(c) & 0xc0U) != 0x80U) {
      ++letters;
    }
  }
  return {rows, widest};
}

// How many of the dots of a text are set.
int dots_of(const std::string& text) {
  int count = 0;
  for (std::size_t i = 0; i + 2 < text.size(); ++i) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[i + k]); };
    if (byte(0) != 0xe2 || byte(1) < 0xa0 || byte(1) > 0xa3) continue;
    count += std::popcount((byte(1) & 3U) << 6U | (byte(2) & 0x3fU));
  }
  return count;
}

}  // namespace

TEST_CASE("a rising line in dots") {
  Figure figure{.title = "ramp", .x = {"time", "s"}, .y = {"", "m"}};
  figure.series.push_back({.label = "arm", .x = {0, 1}, .y = {0, 2}});
  CHECK(to_braille(figure, 8, 4) ==
        "ramp\n"
        "arm\n"
        "m\n"
        "2 │      ⡠⠊\n"
        "1 │    ⡠⠊\n"
        "  │  ⡠⠊⠁\n"
        "0 │⡠⠊\n"
        "  └────────\n"
        "   0 0.5\n"
        "   time (s)\n");
}

TEST_CASE("every row is as wide as asked for, whatever the values") {
  const double inf = std::numeric_limits<double>::infinity();
  for (const std::vector<double>& y : {std::vector<double>{},
                                       {1.0},
                                       {3, 3, 3},
                                       {1e300, -1e300},
                                       {inf, -inf, inf - inf},
                                       {0, 1e-300}}) {
    Figure figure;
    figure.series.push_back({});
    for (std::size_t i = 0; i < y.size(); ++i) figure.series[0].x.push_back(static_cast<double>(i));
    figure.series[0].y = y;
    for (const SeriesKind kind : {SeriesKind::kLine, SeriesKind::kPoints, SeriesKind::kBars}) {
      figure.series[0].kind = kind;
      const std::string text = to_braille(figure, 40, 6);
      CHECK(std::count(text.begin(), text.end(), '\n') >= 8);
      CHECK(text.find("nan") == std::string::npos);
    }
  }
  CHECK_FALSE(to_braille(Figure{}).empty());
  CHECK_FALSE(to_braille(Figure{}, -5, 100'000).empty());
}

TEST_CASE("colours are used only when asked for, and switched off again") {
  Figure figure;
  for (int k = 0; k < 9; ++k) figure.series.push_back({.x = {0, 1}, .y = {0, 1.0 * k}});
  CHECK(to_braille(figure).find('\x1b') == std::string::npos);
  const std::string colored = to_braille(figure, 72, 18, true);
  CHECK(colored.find("\x1b[36m") != std::string::npos);
  CHECK(colored.rfind("\x1b[0m") > colored.rfind("\x1b[3"));
}

TEST_CASE("a figure in space is seen from the front") {
  Figure figure{.x = {"x", "m"}, .y = {"y", "m"}, .z = {"z", "m"}};
  figure.series.push_back({.kind = SeriesKind::kPoints, .x = {0, 0.1}, .y = {5, 7}, .z = {0, 0.2}});
  const std::string text = to_braille(figure, 20, 5);
  CHECK(text.find("z (mm)") != std::string::npos);
  CHECK(text.find("x (mm)") != std::string::npos);
}

TEST_CASE("bars of two series stand side by side, with their names") {
  Figure figure{.y = {"torque", "Nm"}, .names = {"base", "elbow"}};
  figure.series.push_back({.kind = SeriesKind::kBars, .x = {0, 1}, .y = {4, 2}});
  figure.series.push_back({.kind = SeriesKind::kBars, .x = {0, 1}, .y = {1, 3}});
  const std::string text = to_braille(figure, 40, 8);
  CHECK(text.find("base") != std::string::npos);
  CHECK(text.find("elbow") != std::string::npos);
  // On the upper half of the field there are bars of the first series at the first name only.
  const std::string full = "\u28ff\u28ff";
  const std::size_t upper = text.find(full);
  REQUIRE(upper != std::string::npos);
  CHECK(text.substr(upper, text.find('\n', upper) - upper).size() < text.size() / 8);
}

TEST_CASE("panels follow each other, each with its unit") {
  Figure figure{.title = "motion"};
  for (const char* unit : {"rad", "rad/s"}) {
    figure.panels.push_back({.title = unit, .x = {"time", "s"}, .y = {"", unit}});
    figure.panels.back().series.push_back({.label = "joint 1", .x = {0, 1}, .y = {0, 1}});
  }
  const std::string text = to_braille(figure, 40, 16);
  CHECK(text.starts_with("motion\nrad\njoint 1\ndeg\n"));
  CHECK(text.find("\ndeg/s\n") != std::string::npos);
}

TEST_CASE("the axis on the right has its ticks at the heights of those on the left") {
  Figure figure{.x = {"time", "s"}, .y = {"", "rad"}, .right = {"", "m"}};
  figure.series.push_back({.x = {0, 1}, .y = {-1, 1}});
  figure.series.push_back({.x = {0, 1}, .y = {-0.01, 0.02}, .right = true});
  const std::string text = to_braille(figure, 40, 16);
  CHECK(text.find("on the right -20 to 20 mm\n") != std::string::npos);
}

TEST_CASE("a picture is dots where it is bright, in a frame, with its note") {
  Image image(2, 2, PixelKind::kGrey);
  image.row(0)[1] = image.row(1)[0] = 255;
  const Figure figure{
      .title = "checks", .picture = std::make_shared<const Image>(image), .note = "2 x 2, grey"};
  CHECK(to_braille(figure, 8, 4) ==
        "checks\n"
        "┌────────┐\n"
        "│    ⣿⣿⣿⣿│\n"
        "│    ⣿⣿⣿⣿│\n"
        "│⣿⣿⣿⣿    │\n"
        "│⣿⣿⣿⣿    │\n"
        "└────────┘\n"
        "2 x 2, grey\n");
}

TEST_CASE("as many dots are set as a picture is bright") {
  for (const PixelKind kind : {PixelKind::kGrey, PixelKind::kRgb}) {
    for (const int level : {0, 1, 40, 127, 128, 200, 255}) {
      const Figure figure = picture_of(300, 200, kind, static_cast<std::uint8_t>(level));
      const std::string text = to_braille(figure, 60, 20);
      const double share = dots_of(text) / (60.0 * 20.0 * 8.0);
      CAPTURE(level);
      CHECK(std::abs(share - level / 255.0) < 0.02);
    }
  }
}

TEST_CASE("pictures keep their proportions within the room") {
  for (const std::pair<int, int>& size : std::vector<std::pair<int, int>>{
           {1, 1}, {4096, 1}, {1, 4096}, {640, 480}, {3, 7}, {720, 719}}) {
    for (const bool color : {false, true}) {
      const std::string text =
          to_braille(picture_of(size.first, size.second, PixelKind::kRgb, 90), 72, 18, color);
      const auto [rows, columns] = size_of(text);
      CAPTURE(size.first);
      CAPTURE(size.second);
      CHECK(rows >= 5);
      CHECK(rows <= 2 * 18 + 4);
      CHECK(std::count(text.begin(), text.end(), '\x1b') % 2 == 0);
      if (!color) CHECK(columns <= 74);
    }
  }
  CHECK(size_of(to_braille(picture_of(640, 480, PixelKind::kGrey, 0))) == std::pair(27 + 4, 74));
  CHECK(size_of(to_braille(picture_of(100, 400, PixelKind::kGrey, 0))) == std::pair(36 + 4, 20));
}

TEST_CASE("colours of a picture are the nearest of the terminal, two pixels in a character") {
  Image image(1, 2, PixelKind::kRgb);
  const std::uint8_t pixels[] = {255, 0, 0, 120, 121, 122};
  std::copy_n(pixels, 3, image.row(0));
  std::copy_n(pixels + 3, 3, image.row(1));
  const Figure figure{.picture = std::make_shared<const Image>(image)};
  const std::string text = to_braille(figure, 8, 4, true);
  CHECK(text.find("│\x1b[38;5;196;48;5;196m▀") != std::string::npos);
  CHECK(text.find("│\x1b[38;5;243;48;5;243m▀") != std::string::npos);
  CHECK(text.find("▀\x1b[0m│\n") != std::string::npos);
}
