#pragma once

#include <string>
#include <vector>

#include "armlet/plot/figure.hpp"
#include "svg_text.hpp"

namespace armlet::svg {

inline constexpr double kWidth = 720.0;
inline constexpr double kFlatHeight = 420.0;
inline constexpr double kPanelHeight = 168.0;
inline constexpr double kSpatialHeight = 560.0;
inline constexpr std::size_t kManyPoints = 1500;  // more become cells
inline constexpr double kCell = 2.0;              // px

// The room that a figure leaves for what it draws; y grows downwards.
struct Field {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

// A point of a cloud on the page. Of several in one cell the nearest one gives its colour.
struct CloudPoint {
  Point at;
  double near = 0.0;
  int color = 0;
};

// Points as cells of kCell pixels, one path for each class: by how many points a cell holds
// ("f0 few") where `classes` is 0, else by color ("h3").
std::string cells(const Field& field, const std::vector<CloudPoint>& points, int series,
                  int classes);

// "length (mm)"; either part may be empty.
std::string axis_text(const Axis& axis, const PlotUnit& unit);

// A point of series `index`: four shapes, so that series differ not only by colour.
std::string marker(std::size_t index, Point at, double r);

// How a line looks in the plane and in the legend.
std::string line_style(const Series& series, std::size_t index);

struct Plane;

// The part of a figure below its title and legend.
std::string flat_figure(const Plane& plane);
std::string spatial_figure(const Figure& figure, const Field& outer);

// The names of the series in rows below `bottom`, where they end afterwards. The rows begin at
// `left`, the first one `indent` further right.
std::string legend(const Figure& figure, double left, double& bottom, double indent = 0.0);

// The picture of a figure below `bottom`, with its note, where they end afterwards.
std::string picture(const Figure& figure, double& bottom);

// Panels below `bottom`, with a legend for all where they show the same series.
std::string panels(const Figure& figure, double& bottom);

}  // namespace armlet::svg
