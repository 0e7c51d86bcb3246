// Figures in space, seen from the front right and above, without perspective.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "armlet/core/checkpoint.hpp"
#include "armlet/plot/ticks.hpp"
#include "svg_parts.hpp"

namespace armlet::svg {
namespace {

// Viewed from azimuth -60 deg and elevation 22 deg.
constexpr double kSinAzimuth = 0.5, kCosAzimuth = 0.8660254037844386;
constexpr double kSinElevation = 0.374606593415912, kCosElevation = 0.9271838545667874;

struct Place {
  double x = 0.0, y = 0.0, z = 0.0;
};

// Coordinates to the right, up and towards the viewer.
struct Seen {
  double right = 0.0, up = 0.0, near = 0.0;
};
Seen seen(const Place& p) {
  const double depth = -kSinAzimuth * p.x + kCosAzimuth * p.y;  // away from the viewer
  return {kCosAzimuth * p.x + kSinAzimuth * p.y, kCosElevation * p.z + kSinElevation * depth,
          kSinElevation * p.z - kCosElevation * depth};
}

// A box around the values: its size in units of its longest edge, and the scale of each axis.
struct Box {
  PlotUnit unit[3];
  Ticks ticks[3];
  double size[3] = {1.0, 1.0, 1.0};
  Field field;
  double px = 1.0;  // per unit of the box
  Seen centre;

  // From fractions of the edges (0 to 1) to the page.
  Point at(double x, double y, double z, double* near = nullptr) const {
    const Seen s = seen({(x - 0.5) * size[0], (y - 0.5) * size[1], (z - 0.5) * size[2]});
    if (near != nullptr) *near = s.near;
    return {0.5 * (field.left + field.right) + px * s.right,
            0.5 * (field.top + field.bottom) - px * s.up};
  }
};

const Axis& axis_of(const Figure& figure, int k) {
  return k == 0 ? figure.x : k == 1 ? figure.y : figure.z;
}

const std::vector<double>& values_of(const Series& series, int k) {
  return k == 0 ? series.x : k == 1 ? series.y : series.z;
}

Box box_of(const Figure& figure, const Field& outer) {
  Box box;
  Extent extent[3];
  double largest = 0.0;
  for (int k = 0; k < 3; ++k) {
    std::vector<const std::vector<double>*> lists;
    for (const Series& series : figure.series) lists.push_back(&values_of(series, k));
    extent[k] = extent_of(lists);
    largest = std::max({largest, std::abs(extent[k].lower), std::abs(extent[k].upper)});
  }
  double longest = 0.0;
  for (int k = 0; k < 3; ++k) {
    box.unit[k] = plot_unit(axis_of(figure, k).unit, largest);
    const double factor = box.unit[k].factor;
    box.ticks[k] = make_ticks(extent[k].lower * factor, extent[k].upper * factor, 7, false, true);
    longest = std::max(longest, box.ticks[k].upper - box.ticks[k].lower);
  }
  // One scale for all axes, unless an axis becomes too short to see.
  const bool alike = figure.x.unit == figure.y.unit && figure.y.unit == figure.z.unit;
  for (int k = 0; k < 3 && alike; ++k) {
    box.size[k] = std::max((box.ticks[k].upper - box.ticks[k].lower) / longest, 0.15);
  }
  box.field = {outer.left + 40.0, outer.top + 8.0, outer.right - 40.0, outer.bottom - 40.0};
  const double wide = kCosAzimuth * box.size[0] + kSinAzimuth * box.size[1];
  const double high = kCosElevation * box.size[2] +
                      kSinElevation * (kSinAzimuth * box.size[0] + kCosAzimuth * box.size[1]);
  box.px = std::min(box.field.width() / wide, box.field.height() / high);
  return box;
}

std::string edge(const Box& box, std::array<double, 3> from, std::array<double, 3> to,
                 std::string_view css) {
  return line(box.at(from[0], from[1], from[2]), box.at(to[0], to[1], to[2]), css);
}

// The floor and the two back walls, with a grid, and the values along the near edges of the floor
// and the left edge of the wall.
std::string axes(const Figure& figure, const Box& box) {
  std::string out;
  for (int k = 0; k < 3; ++k) {
    for (const double value : box.ticks[k].at) {
      const double f = box.ticks[k].position(value);
      // Grid lines on the two faces that cut this coordinate: floor z = 0, walls y = 1 and x = 0.
      if (k == 0)
        out += edge(box, {f, 0, 0}, {f, 1, 0}, "grid") + edge(box, {f, 1, 0}, {f, 1, 1}, "grid");
      if (k == 1)
        out += edge(box, {0, f, 0}, {1, f, 0}, "grid") + edge(box, {0, f, 0}, {0, f, 1}, "grid");
      if (k == 2)
        out += edge(box, {0, 1, f}, {1, 1, f}, "grid") + edge(box, {0, 0, f}, {0, 1, f}, "grid");
    }
  }
  out += edge(box, {0, 0, 0}, {1, 0, 0}, "frame") + edge(box, {1, 0, 0}, {1, 1, 0}, "frame") +
         edge(box, {0, 0, 0}, {0, 0, 1}, "frame") + edge(box, {0, 1, 0}, {0, 1, 1}, "frame");
  for (int k = 0; k < 3; ++k) {
    const Ticks& ticks = box.ticks[k];
    for (std::size_t i = 0; i < ticks.at.size(); ++i) {
      const double f = ticks.position(ticks.at[i]);
      Point at = k == 0 ? box.at(f, 0, 0) : k == 1 ? box.at(1, f, 0) : box.at(0, 0, f);
      if (k == 2) {
        out += text({at.x - 7.0, at.y + 4.0}, "end", "tick", with_minus(ticks.labels[i]));
      } else if (k == 0) {
        out += text({at.x - 4.0, at.y + 18.0}, "middle", "tick", with_minus(ticks.labels[i]));
      } else {
        out += text({at.x + 8.0, at.y + 8.0}, "start", "tick", with_minus(ticks.labels[i]));
      }
    }
    const std::string name = axis_text(axis_of(figure, k), box.unit[k]);
    const Point at = k == 0 ? box.at(0.5, 0, 0) : k == 1 ? box.at(1, 0.5, 0) : box.at(0, 0, 1);
    if (name.empty()) continue;
    if (k == 2) {
      out += text({at.x, at.y - 10.0}, "middle", "axis", name);
    } else {
      out += text({at.x + (k == 0 ? -34.0 : 40.0), at.y + 34.0}, k == 0 ? "end" : "start", "axis",
                  name);
    }
  }
  return out;
}

}  // namespace

std::string spatial_figure(const Figure& figure, const Field& outer) {
  constexpr std::uint64_t kPointCost = 64;  // operations
  const Box box = box_of(figure, outer);
  std::string out = axes(figure, box);
  std::vector<CloudPoint> points;
  for (const Series& series : figure.series) {
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      checkpoint(kPointCost);
      if (!is_drawable(series.x[i]) || !is_drawable(series.y[i]) || !is_drawable(series.z[i]))
        continue;
      const double height = box.ticks[2].position(series.z[i] * box.unit[2].factor);
      CloudPoint point;
      point.at =
          box.at(box.ticks[0].position(series.x[i] * box.unit[0].factor),
                 box.ticks[1].position(series.y[i] * box.unit[1].factor), height, &point.near);
      point.color = std::clamp(static_cast<int>(height * kHeightColors), 0, kHeightColors - 1);
      points.push_back(point);
    }
  }
  if (points.size() > kManyPoints) return out + cells(box.field, points, 0, kHeightColors);
  std::ranges::stable_sort(points, {}, &CloudPoint::near);
  for (const CloudPoint& point : points) {
    out += fmt::format("<circle class=\"h{}\" cx=\"{}\" cy=\"{}\" r=\"2.5\"/>\n", point.color,
                       coordinate(point.at.x), coordinate(point.at.y));
  }
  return out;
}

}  // namespace armlet::svg
