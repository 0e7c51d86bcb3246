// Lines, points and bars of figures in the plane.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/checkpoint.hpp"
#include "svg_plane.hpp"

namespace armlet::svg {
namespace {

// Operations per value, for checkpoints.
constexpr std::uint64_t kValueCost = 32;
constexpr std::uint64_t kBarCost = 1000;

// Keeps the first, lowest, highest and last value of a line in each column of pixels: more is not
// visible.
std::vector<Point> thinned(const std::vector<Point>& points, double width) {
  if (static_cast<double>(points.size()) < 6.0 * width) return points;
  std::vector<Point> kept;
  for (std::size_t begin = 0; begin < points.size();) {
    std::size_t end = begin, low = begin, high = begin;
    while (end < points.size() && std::floor(points[end].x) == std::floor(points[begin].x)) {
      if (points[end].y < points[low].y) low = end;
      if (points[end].y > points[high].y) high = end;
      ++end;
    }
    std::size_t last = points.size();
    for (const std::size_t i : {begin, std::min(low, high), std::max(low, high), end - 1}) {
      if (i != last) kept.push_back(points[i]);
      last = i;
    }
    begin = end;
  }
  return kept;
}

std::string stroke(const std::vector<Point>& points, const std::string& css, double width,
                   int color) {
  if (points.empty()) return {};
  if (points.size() == 1) {
    return fmt::format("<circle class=\"f{}\" cx=\"{}\" cy=\"{}\" r=\"3\"/>\n", color,
                       coordinate(points[0].x), coordinate(points[0].y));
  }
  std::string d;
  for (const Point& p : thinned(points, width)) {
    d += fmt::format("{}{} {}", d.empty() ? "M" : "L", coordinate(p.x), coordinate(p.y));
  }
  return fmt::format("<path class=\"{}\" d=\"{}\"/>\n", css, d);
}

std::string draw_line(const Plane& plane, const Series& series, std::size_t index) {
  const int color = static_cast<int>(index % kSeriesColors);
  const std::string css = line_style(series, index);
  std::string out;
  std::vector<Point> piece;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    checkpoint(kValueCost);
    if (plane.shows(series, i)) {
      piece.push_back(plane.at(series.x[i], series.y[i], series.right));
      continue;
    }
    out += stroke(piece, css, plane.field.width(), color);
    piece.clear();
  }
  return out + stroke(piece, css, plane.field.width(), color);
}

std::string draw_points(const Plane& plane, const Series& series, std::size_t index) {
  const int color = static_cast<int>(index % kSeriesColors);
  std::vector<CloudPoint> points;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    checkpoint(kValueCost);
    if (plane.shows(series, i)) {
      points.push_back({plane.at(series.x[i], series.y[i], series.right)});
    }
  }
  if (points.size() > kManyPoints) return cells(plane.field, points, color, 0);
  std::string out;
  for (const CloudPoint& point : points) out += marker(index, point.at, 2.5);
  return out;
}

std::string draw_bars(const Plane& plane, const Series& series, std::size_t index) {
  const BarSpan span = bar_span(plane.figure, index, plane.bar);
  std::string d;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    checkpoint(kBarCost);
    if (!plane.shows(series, i)) continue;
    const std::string from = coordinate(plane.x.at(series.x[i] + span.begin));
    const Point to = plane.at(series.x[i] + span.end, series.y[i], series.right);
    d += fmt::format("M{} {}H{}V{}H{}z", from, coordinate(plane.ground(series.right)),
                     coordinate(to.x), coordinate(to.y), from);
  }
  if (d.empty()) return d;
  return fmt::format("<path class=\"f{}\" d=\"{}\"/>\n", index % kSeriesColors, d);
}

}  // namespace

std::string marker(std::size_t index, Point at, double r) {
  const std::size_t color = index % kSeriesColors;
  const std::string x = coordinate(at.x), y = coordinate(at.y);
  const auto shape = [&](double left, double top, std::string_view rest) {
    return fmt::format("<path class=\"f{}\" d=\"M{} {}{}\"/>\n", color, coordinate(at.x - left),
                       coordinate(at.y - top), rest);
  };
  const std::string wide = coordinate(1.8 * r), half = coordinate(1.3 * r);
  switch (index % 4) {
    case 1:  // a square
      return shape(0.9 * r, 0.9 * r, fmt::format("h{0}v{0}h-{0}z", wide));
    case 2:  // a triangle
      return shape(0.0, 1.3 * r,
                   fmt::format("l{0} {1}h-{2}z", half, coordinate(2.2 * r), coordinate(2.6 * r)));
    case 3:  // a diamond
      return shape(0.0, 1.3 * r, fmt::format("l{0} {0}l-{0} {0}l-{0} -{0}z", half));
    default:
      return fmt::format("<circle class=\"f{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", color, x, y,
                         coordinate(r));
  }
}

std::string line_style(const Series& series, std::size_t index) {
  return fmt::format("s s{}{}", index % kSeriesColors,
                     series.right             ? " aside"
                     : index >= kSeriesColors ? " dash"
                                              : "");
}

std::string flat_figure(const Plane& plane) {
  std::string out = axes(plane);
  for (std::size_t i = 0; i < plane.figure.series.size(); ++i) {
    const Series& series = plane.figure.series[i];
    switch (series.kind) {
      case SeriesKind::kLine:
        out += draw_line(plane, series, i);
        break;
      case SeriesKind::kPoints:
        out += draw_points(plane, series, i);
        break;
      case SeriesKind::kBars:
        out += draw_bars(plane, series, i);
        break;
    }
  }
  return out;
}

}  // namespace armlet::svg
