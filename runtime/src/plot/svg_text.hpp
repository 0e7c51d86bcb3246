#pragma once

#include <string>
#include <string_view>

// Pieces of SVG.
namespace armlet::svg {

// A coordinate with at most two decimals, "0" never negative.
std::string coordinate(double value);

// Approximate width of a text, px.
double width_of(std::string_view text, double size);

// A number with a minus sign instead of a hyphen.
std::string with_minus(std::string number);

struct Point {
  double x = 0.0, y = 0.0;
};

// A text at a point; anchor is "start", "middle" or "end".
std::string text(Point at, std::string_view anchor, std::string_view css, std::string_view content,
                 std::string_view more = {});
std::string line(Point from, Point to, std::string_view css);

// Colours of series and of heights, style of axes and text: one style sheet for light and dark
// pages.
std::string_view style();

inline constexpr int kSeriesColors = 7;
inline constexpr int kHeightColors = 8;

}  // namespace armlet::svg
