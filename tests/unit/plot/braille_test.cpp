#include "armlet/plot/braille.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

using namespace armlet;

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
