#pragma once

#include "armlet/plot/ticks.hpp"
#include "svg_parts.hpp"

namespace armlet::svg {

inline constexpr double kLetter = 12.0;

// Maps values in SI units to pixels.
struct Scale {
  PlotUnit unit;
  Ticks ticks;
  double from = 0.0, to = 1.0;  // px of ticks.lower and ticks.upper

  double at(double si) const { return from + (to - from) * ticks.position(si * unit.factor); }
};

// The layout of a figure on the page.
struct Plane {
  const Figure& figure;
  Field field;
  Scale x, y, right;
  // least distance between positions of bars, SI; 1 if there is only one
  double bar = 1.0;
  bool named_below = true;     // the x axis has values and a name
  bool slanted_names = false;  // below bars
  double name_at = 15.0;       // px, position of the name of the axis on the left

  const Scale& up(bool on_right) const { return on_right ? right : y; }
  Point at(double px, double py, bool on_right) const { return {x.at(px), up(on_right).at(py)}; }
  // The value at which bars begin.
  double ground(bool on_right) const {
    return up(on_right).ticks.log ? field.bottom : up(on_right).at(0.0);
  }
  bool has_right() const;
  // Whether a point of a series can be drawn.
  bool shows(const Series& series, std::size_t i) const;
};

// The common data of the panels of a figure.
struct PanelFrame {
  const Extent* x = nullptr;       // null: that of the values
  double left = 0.0, right = 0.0;  // px of the edges of the area; 0: determined by the labels
  bool named_below = true;
};

Extent x_extent(const Figure& figure);
// The height of a figure without title and legend, px: that of a map follows from its shape.
double flat_height(const Figure& figure);
Plane plane_of(const Figure& figure, const Field& outer, const PanelFrame& frame = {});

// A name with at most kLongestName letters.
std::string shortened(const std::string& name);

// Grid, values and names of the axes.
std::string axes(const Plane& plane);

}  // namespace armlet::svg
