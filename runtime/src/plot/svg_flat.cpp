// Figures in the plane.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/plot/ticks.hpp"
#include "svg_parts.hpp"

namespace armlet::svg {
namespace {

constexpr double kLetter = 12.0;

// From values in SI units to pixels.
struct Scale {
  PlotUnit unit;
  Ticks ticks;
  double from = 0.0, to = 1.0;  // px of ticks.lower and ticks.upper

  double at(double si) const { return from + (to - from) * ticks.position(si * unit.factor); }
};

// Values of the series that `wanted` accepts.
template <class Wanted>
std::vector<const std::vector<double>*> columns(const Figure& figure,
                                                std::vector<double> Series::*part, Wanted wanted) {
  std::vector<const std::vector<double>*> lists;
  for (const Series& series : figure.series) {
    if (wanted(series)) lists.push_back(&(series.*part));
  }
  return lists;
}
bool any_side(const Series&) { return true; }
bool on_the_left(const Series& series) { return !series.right; }
bool on_the_right(const Series& series) { return series.right; }

bool has_bars(const Figure& figure) {
  return std::ranges::any_of(figure.series,
                             [](const Series& s) { return s.kind == SeriesKind::kBars; });
}

// The least distance between places of bars, SI; 1 if there is only one.
double bar_pitch(const Figure& figure) {
  std::vector<double> places;
  for (const Series& series : figure.series) {
    for (const double x : series.x) {
      if (series.kind == SeriesKind::kBars && is_drawable(x)) places.push_back(x);
    }
  }
  std::ranges::sort(places);
  double pitch = 0.0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double step = places[i] - places[i - 1];
    if (step > 0.0 && (pitch == 0.0 || step < pitch)) pitch = step;
  }
  return pitch > 0.0 ? pitch : 1.0;
}

struct Plane {
  const Figure& figure;
  Field field;
  Scale x, y, right;
  double bar = 1.0;  // pitch of bars, SI

  Point at(double px, double py, bool on_right) const {
    return {x.at(px), on_right ? right.at(py) : y.at(py)};
  }
  bool has_right() const { return std::ranges::any_of(figure.series, on_the_right); }
};

PlotUnit unit_of(const Axis& axis, const Extent& extent) {
  return plot_unit(axis.unit, std::max(std::abs(extent.lower), std::abs(extent.upper)));
}

// Lengths on both axes are drawn to one scale, so that circles are round.
bool is_map(const Figure& figure) { return figure.x.unit == "m" && figure.y.unit == "m"; }

double widest(const Ticks& ticks) {
  double width = 0.0;
  for (const std::string& label : ticks.labels) width = std::max(width, width_of(label, kLetter));
  return width;
}

// Ticks of an upright axis, which begins and ends at one.
void set_upright(Scale& scale, const Extent& extent) {
  const bool degrees = scale.unit.text == "deg";
  scale.ticks = make_ticks(extent.lower * scale.unit.factor, extent.upper * scale.unit.factor, 6,
                           degrees, true);
}

// One scale for both axes: the one with room to spare shows more around the middle.
void make_even(Ticks& h, Ticks& v, const Field& field) {
  const double per_px =
      std::max((h.upper - h.lower) / field.width(), (v.upper - v.lower) / field.height());
  const double more_x = 0.5 * (per_px * field.width() - (h.upper - h.lower));
  const double more_y = 0.5 * (per_px * field.height() - (v.upper - v.lower));
  h = make_ticks(h.lower - more_x, h.upper + more_x, 8, false, false);
  v = make_ticks(v.lower - more_y, v.upper + more_y, 6, false, false);
}

Plane plane_of(const Figure& figure, const Field& outer) {
  Plane plane{figure, outer, {}, {}, {}, 1.0};
  Extent x = extent_of(columns(figure, &Series::x, any_side));
  Extent y = extent_of(columns(figure, &Series::y, on_the_left));
  if (has_bars(figure)) {
    plane.bar = bar_pitch(figure);
    x.lower -= 0.5 * plane.bar;
    x.upper += 0.5 * plane.bar;
    y.lower = std::min(y.lower, 0.0);
    y.upper = std::max(y.upper, 0.0);
  }
  plane.x.unit = unit_of(figure.x, x);
  plane.y.unit = unit_of(figure.y, y);
  if (is_map(figure)) {
    const Extent both{std::min(x.lower, y.lower), std::max(x.upper, y.upper)};
    plane.x.unit = plane.y.unit = unit_of(figure.x, both);
  }
  set_upright(plane.y, y);
  plane.field = {outer.left + widest(plane.y.ticks) + 34.0, outer.top + 8.0, outer.right - 18.0,
                 outer.bottom - 44.0};
  if (plane.has_right()) {
    const Extent right = extent_of(columns(figure, &Series::y, on_the_right));
    plane.right.unit = unit_of(figure.right, right);
    set_upright(plane.right, right);
    plane.field.right -= widest(plane.right.ticks) + 24.0;
  }
  const bool lines = std::ranges::all_of(
      figure.series, [](const Series& s) { return s.kind == SeriesKind::kLine; });
  plane.x.ticks = make_ticks(x.lower * plane.x.unit.factor, x.upper * plane.x.unit.factor, 8,
                             plane.x.unit.text == "deg", !lines && !has_bars(figure));
  if (is_map(figure) && !plane.has_right()) make_even(plane.x.ticks, plane.y.ticks, plane.field);
  plane.x.from = plane.field.left;
  plane.x.to = plane.field.right;
  plane.y.from = plane.right.from = plane.field.bottom;
  plane.y.to = plane.right.to = plane.field.top;
  return plane;
}

// Values and name of the axis on the right.
std::string right_axis(const Plane& plane) {
  if (!plane.has_right()) return {};
  const Field& field = plane.field;
  const Ticks& ticks = plane.right.ticks;
  std::string out = line({field.right, field.top}, {field.right, field.bottom}, "frame");
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    const double y = field.bottom - field.height() * ticks.position(ticks.at[i]);
    out += line({field.right, y}, {field.right + 4.0, y}, "frame");
    out += text({field.right + 8.0, y + 4.0}, "start", "tick", ticks.labels[i]);
  }
  const std::string name = axis_text(plane.figure.right, plane.right.unit);
  if (name.empty()) return out;
  const double x = kWidth - 13.0, y = 0.5 * (field.top + field.bottom);  // letters rise rightwards
  return out + text({x, y}, "middle", "axis", name,
                    fmt::format(" transform=\"rotate(90 {} {})\"", coordinate(x), coordinate(y)));
}

std::string axes(const Plane& plane) {
  const Field& field = plane.field;
  std::string out;
  const Ticks &h = plane.x.ticks, &v = plane.y.ticks;
  for (std::size_t i = 0; i < h.at.size(); ++i) {
    const double x = field.left + field.width() * h.position(h.at[i]);
    out += line({x, field.top}, {x, field.bottom}, "grid");
    out += text({x, field.bottom + 17.0}, "middle", "tick", h.labels[i]);
  }
  for (std::size_t i = 0; i < v.at.size(); ++i) {
    const double y = field.bottom - field.height() * v.position(v.at[i]);
    out += line({field.left, y}, {field.right, y}, "grid");
    out += text({field.left - 7.0, y + 4.0}, "end", "tick", v.labels[i]);
  }
  out += fmt::format("<path class=\"frame\" d=\"M{} {}V{}H{}\"/>\n", coordinate(field.left),
                     coordinate(field.top), coordinate(field.bottom), coordinate(field.right));
  const std::string below = axis_text(plane.figure.x, plane.x.unit),
                    beside = axis_text(plane.figure.y, plane.y.unit);
  if (!below.empty())
    out += text({0.5 * (field.left + field.right), field.bottom + 37.0}, "middle", "axis", below);
  if (!beside.empty()) {
    const double x = 15.0, y = 0.5 * (field.top + field.bottom);
    out += text({x, y}, "middle", "axis", beside,
                fmt::format(" transform=\"rotate(-90 {} {})\"", coordinate(x), coordinate(y)));
  }
  return out;
}

// In each column of pixels a line keeps its first, lowest, highest and last value: more cannot be
// seen.
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
  const std::string css = fmt::format("s s{}{}", color, index >= kSeriesColors ? " dash" : "");
  std::string out;
  std::vector<Point> piece;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (is_drawable(series.x[i]) && is_drawable(series.y[i])) {
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
    if (is_drawable(series.x[i]) && is_drawable(series.y[i])) {
      points.push_back({plane.at(series.x[i], series.y[i], series.right)});
    }
  }
  if (points.size() > kManyPoints) return cells(plane.field, points, color, 0);
  std::string out;
  for (const CloudPoint& point : points) {
    out += fmt::format("<circle class=\"f{}\" cx=\"{}\" cy=\"{}\" r=\"2.5\"/>\n", color,
                       coordinate(point.at.x), coordinate(point.at.y));
  }
  return out;
}

std::string draw_bars(const Plane& plane, const Series& series, std::size_t index) {
  std::size_t groups = 0, before = 0;
  for (std::size_t s = 0; s < plane.figure.series.size(); ++s) {
    if (plane.figure.series[s].kind != SeriesKind::kBars) continue;
    if (s < index) ++before;
    ++groups;
  }
  const double width = 0.8 * plane.bar / static_cast<double>(groups);
  std::string d;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!is_drawable(series.x[i]) || !is_drawable(series.y[i])) continue;
    const double left = series.x[i] - 0.4 * plane.bar + width * static_cast<double>(before);
    const Point a = plane.at(left, 0.0, series.right);
    const Point b = plane.at(left + 0.94 * width, series.y[i], series.right);
    d += fmt::format("M{} {}H{}V{}H{}z", coordinate(a.x), coordinate(a.y), coordinate(b.x),
                     coordinate(b.y), coordinate(a.x));
  }
  if (d.empty()) return d;
  return fmt::format("<path class=\"f{}\" d=\"{}\"/>\n", index % kSeriesColors, d);
}

}  // namespace

std::string flat_figure(const Figure& figure, const Field& outer) {
  const Plane plane = plane_of(figure, outer);
  std::string out = axes(plane) + right_axis(plane);
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    const Series& series = figure.series[i];
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
