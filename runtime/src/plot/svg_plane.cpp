#include "svg_plane.hpp"

#include <algorithm>
#include <cmath>

namespace armlet::svg {
namespace {

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
bool is_bars(const Series& series) { return series.kind == SeriesKind::kBars; }

PlotUnit unit_of(const Axis& axis, const Extent& extent) {
  return plot_unit(axis.unit, std::max(std::abs(extent.lower), std::abs(extent.upper)));
}

// Whether both axes are lengths; they are drawn to one scale then, so that circles are round.
bool is_map(const Figure& figure) {
  return figure.x.unit == "m" && figure.y.unit == "m" && !figure.x.log && !figure.y.log &&
         std::ranges::none_of(figure.series, on_the_right);
}

double widest(const std::vector<std::string>& labels) {
  double width = 0.0;
  for (const std::string& label : labels) width = std::max(width, width_of(label, kLetter));
  return width;
}

// Ticks of an axis for an extent of values; `whole` axes begin and end at a tick.
void set_ticks(Scale& scale, const Axis& axis, const Extent& extent, int wanted, bool whole) {
  const double lower = extent.lower * scale.unit.factor, upper = extent.upper * scale.unit.factor;
  scale.ticks = axis.log ? make_log_ticks(lower, upper, wanted)
                         : make_ticks(lower, upper, wanted, scale.unit.text == "deg", whole);
}

// Range of values of a vertical axis; bars begin at zero.
Extent y_extent(const Figure& figure, bool right) {
  const Axis& axis = right ? figure.right : figure.y;
  Extent extent = extent_of(columns(figure, &Series::y, right ? on_the_right : on_the_left), axis);
  const bool stands = std::ranges::any_of(
      figure.series, [right](const Series& s) { return is_bars(s) && s.right == right; });
  if (stands && !axis.log) {
    extent.lower = std::min(extent.lower, 0.0);
    extent.upper = std::max(extent.upper, 0.0);
  }
  return extent;
}

// Ticks of the axis on the right, at the grid lines if both axes are linear.
void set_right(Plane& plane, int wanted) {
  const Extent extent = y_extent(plane.figure, true);
  Scale& scale = plane.right;
  scale.unit = unit_of(plane.figure.right, extent);
  if (plane.figure.right.log || plane.figure.y.log)
    return set_ticks(scale, plane.figure.right, extent, wanted, true);
  scale.ticks =
      make_parallel_ticks(extent.lower * scale.unit.factor, extent.upper * scale.unit.factor,
                          plane.y.ticks, scale.unit.text == "deg");
}

// Ticks of a map, whose axes begin and end at a tick. The shorter side is extended around its
// middle if the map would be a thin strip.
void set_map_ticks(Plane& plane, Extent x, Extent y) {
  constexpr double kThinnest = 0.25;
  const double longest = std::max(x.upper - x.lower, y.upper - y.lower);
  for (Extent* side : {&x, &y}) {
    const double more = 0.5 * (kThinnest * longest - (side->upper - side->lower));
    if (more <= 0.0) continue;
    side->lower -= more;
    side->upper += more;
  }
  const auto wanted = [&](const Extent& side) {
    return longest > 0.0 ? static_cast<int>(8.0 * (side.upper - side.lower) / longest + 0.5) : 6;
  };
  set_ticks(plane.x, plane.figure.x, x, wanted(x), true);
  set_ticks(plane.y, plane.figure.y, y, wanted(y), true);
}

double span(const Scale& scale) { return scale.ticks.upper - scale.ticks.lower; }

// The largest area with the map's aspect ratio, centred in the available room.
void fit_map(Plane& plane) {
  Field& field = plane.field;
  const double px = std::min(field.width() / span(plane.x), field.height() / span(plane.y));
  const double spare = field.width() - px * span(plane.x);
  field.left += 0.5 * spare;
  field.right -= 0.5 * spare;
  field.bottom = field.top + px * span(plane.y);
  plane.name_at += 0.5 * spare;
}

constexpr double kBelowNamed = 46.0;  // px for values and a name

// Makes room on the left for rotated names; returns the height that they need below.
double lean_names(Plane& plane, double each) {
  constexpr double kCos = 0.766, kSin = 0.643;  // of 40 deg
  double longest = 0.0, beyond = 0.0, place = plane.field.left + 0.5 * each;
  for (const std::string& name : plane.figure.names) {
    const double width = width_of(shortened(name), kLetter);
    longest = std::max(longest, width);
    beyond = std::max(beyond, 8.0 + kCos * width - place);
    place += each;
  }
  plane.field.left += beyond;
  plane.name_at += beyond;
  return 24.0 + kSin * longest;
}

// The height that the values and the name below the area need.
double room_below(Plane& plane) {
  if (!plane.named_below) return 8.0;
  const std::vector<std::string>& names = plane.figure.names;
  if (names.empty()) return axis_text(plane.figure.x, plane.x.unit).empty() ? 28.0 : kBelowNamed;
  const double each = plane.field.width() / static_cast<double>(names.size());
  plane.slanted_names = widest(names) > each - 6.0;
  return plane.slanted_names ? lean_names(plane, each) : 28.0;
}

void set_x(Plane& plane, const Extent& extent) {
  const Figure& figure = plane.figure;
  if (!figure.names.empty()) {
    plane.x.ticks = make_name_ticks(figure.names);
    return;
  }
  const bool tight = std::ranges::all_of(
      figure.series, [](const Series& s) { return s.kind == SeriesKind::kLine || is_bars(s); });
  set_ticks(plane.x, figure.x, extent, 8, !tight);
}

}  // namespace

bool Plane::has_right() const { return std::ranges::any_of(figure.series, on_the_right); }

bool Plane::shows(const Series& series, std::size_t i) const {
  return is_drawable(series.x[i], figure.x) &&
         is_drawable(series.y[i], series.right ? figure.right : figure.y);
}

Extent x_extent(const Figure& figure) {
  Extent x = extent_of(columns(figure, &Series::x, any_side), figure.x);
  if (std::ranges::any_of(figure.series, is_bars) && !figure.x.log) {
    const double pitch = bar_pitch(figure);
    x.lower -= 0.5 * pitch;
    x.upper += 0.5 * pitch;
  }
  return x;
}

Plane plane_of(const Figure& figure, const Field& outer, const PanelFrame& frame) {
  Plane plane{.figure = figure, .field = outer, .x = {}, .y = {}, .right = {}};
  plane.named_below = frame.named_below;
  plane.bar = bar_pitch(figure);
  const bool map = is_map(figure);
  const Extent x = frame.x != nullptr ? *frame.x : x_extent(figure);
  const Extent y = y_extent(figure, false);
  plane.x.unit = unit_of(figure.x, x);
  plane.y.unit = unit_of(figure.y, y);
  if (map) {
    const Extent both{std::min(x.lower, y.lower), std::max(x.upper, y.upper)};
    plane.x.unit = plane.y.unit = unit_of(figure.x, both);
    set_map_ticks(plane, x, y);
  }
  const int wanted = outer.height() < 250.0 ? 4 : 6;
  if (!map) set_ticks(plane.y, figure.y, y, wanted, true);
  plane.field = {outer.left + widest(plane.y.ticks.labels) + 34.0, outer.top + 8.0,
                 outer.right - 18.0, outer.bottom};
  if (plane.has_right()) {
    set_right(plane, wanted);
    plane.field.right -= widest(plane.right.ticks.labels) + 24.0;
  }
  if (frame.left > 0.0) plane.field.left = frame.left;
  if (frame.right > 0.0) plane.field.right = frame.right;
  if (!map) set_x(plane, x);
  plane.field.bottom -= room_below(plane);
  if (map) fit_map(plane);
  plane.x.from = plane.field.left;
  plane.x.to = plane.field.right;
  plane.y.from = plane.right.from = plane.field.bottom;
  plane.y.to = plane.right.to = plane.field.top;
  return plane;
}

double flat_height(const Figure& figure) {
  if (!is_map(figure)) return kFlatHeight;
  constexpr double kTallest = 560.0;
  const Plane plane = plane_of(figure, {6.0, 0.0, kWidth, kTallest});
  return plane.field.bottom + kBelowNamed;
}

}  // namespace armlet::svg
