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
inline constexpr std::size_t kManyPoints = 1500;  // with more of them cells are drawn
inline constexpr double kCell = 2.0;              // px

// The drawing area of a figure; y grows downwards.
struct Field {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

// A point of a cloud in page coordinates. The nearest point in a cell determines its colour.
struct CloudPoint {
  Point at;
  double near = 0.0;
  int color = 0;
};

// Draws points as cells of kCell pixels, one path for each class: the number of points in a cell
// ("f0 few") if `classes` is 0, else the colour ("h3").
std::string cells(const Field& field, const std::vector<CloudPoint>& points, int series,
                  int classes);

// "length (mm)"; either part may be empty.
std::string axis_text(const Axis& axis, const PlotUnit& unit);

// A point of series `index`: four shapes, so that series differ not only by colour.
std::string marker(std::size_t index, Point at, double r);

// The style of a line in the plot and in the legend.
std::string line_style(const Series& series, std::size_t index);

struct Plane;

// The part of a figure below its title and legend.
std::string flat_figure(const Plane& plane);
std::string spatial_figure(const Figure& figure, const Field& outer);

// The names of the series in rows below `bottom`, which becomes their lower edge. The rows begin at
// `left`, the first one `indent` further right.
std::string legend(const Figure& figure, double left, double& bottom, double indent = 0.0);

// The picture of a figure below `bottom`, with its note; `bottom` becomes their lower edge.
std::string picture(const Figure& figure, double& bottom);

// Panels below `bottom`, with a common legend if they show the same series.
std::string panels(const Figure& figure, double& bottom);

}  // namespace armlet::svg
