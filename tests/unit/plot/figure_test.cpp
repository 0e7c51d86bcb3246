#include "armlet/plot/figure.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace armlet;

TEST_CASE("people read degrees, and millimetres of what is short") {
  CHECK(plot_unit("rad", 3.0).text == "deg");
  CHECK(plot_unit("rad", 3.0).factor == doctest::Approx(57.29577951));
  CHECK(plot_unit("rad/s", 3.0).text == "deg/s");
  CHECK(plot_unit("rad/s^2", 3.0).text == "deg/s^2");
  CHECK(plot_unit("m", 0.7).text == "mm");
  CHECK(plot_unit("m", 1.2).text == "m");
  CHECK(plot_unit("m/s", 0.2).text == "mm/s");
  CHECK(plot_unit("kg", 0.2).text == "g");
  CHECK(plot_unit("s", 0.001).text == "s");
  CHECK(plot_unit("", 5.0).text.empty());
  CHECK(plot_unit("Nm", 5.0).factor == 1.0);
}

TEST_CASE("what cannot be drawn is left out of the extent") {
  const double inf = std::numeric_limits<double>::infinity(), nan = inf - inf;
  const std::vector<double> a{3.0, nan, -2.0}, b{inf, 7.0, 1e308};
  const Extent extent = extent_of({&a, &b});
  CHECK(extent.lower == -2.0);
  CHECK(extent.upper == 7.0);
  CHECK(extent.count == 3);
  const std::vector<double> none{nan, -inf};
  CHECK(extent_of({&none}).count == 0);
  CHECK(extent_of({&none}).upper == 1.0);
}

TEST_CASE("a logarithmic axis counts values above zero only") {
  const std::vector<double> values{0.0, -3.0, 0.5, 20.0};
  const Axis axis{.log = true};
  CHECK(extent_of({&values}, axis).lower == 0.5);
  CHECK(extent_of({&values}, axis).count == 2);
  CHECK(extent_of({}, axis).lower > 0.0);
}

TEST_CASE("bars at one position share it") {
  Figure figure;
  for (int k = 0; k < 3; ++k) {
    figure.series.push_back({.kind = SeriesKind::kBars, .x = {1, 1.5, 4}, .y = {1, 2, 3}});
    if (k == 0) figure.series.push_back({.x = {0, 0.1}, .y = {0, 1}});
  }
  const double pitch = bar_pitch(figure);
  CHECK(pitch == 0.5);
  const std::size_t bars[] = {0, 2, 3};
  double last = -0.5 * pitch;
  for (const std::size_t s : bars) {
    const BarSpan span = bar_span(figure, s, pitch);
    CHECK(span.begin > last);
    CHECK(span.end > span.begin);
    last = span.end;
  }
  CHECK(last < 0.5 * pitch);
  CHECK(bar_pitch(Figure{}) == 1.0);
}
