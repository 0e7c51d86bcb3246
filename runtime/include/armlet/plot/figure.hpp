#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/image/image.hpp"

namespace armlet {

enum class SeriesKind { kLine, kPoints, kBars };

// "line", "points" or "bars".
std::string_view to_text(SeriesKind kind);

// Values of one series, in SI units: x and y, and z in space. Elements of the same index make a
// point.
struct Series {
  SeriesKind kind = SeriesKind::kLine;
  std::string label{};
  std::vector<double> x{}, y{}, z{};
  bool right = false;  // y belongs to the axis on the right
};

// An axis. `unit` is the SI unit of the values ("m", "rad/s"), empty for plain numbers; pictures
// choose deg, mm and so on themselves.
//
// read  the unit that was inferred from the text of the program, for values whose type has none;
//       `unit` is empty if the axis also has numbers of unknown unit.
struct Axis {
  std::string label{};
  std::string unit{};
  bool log = false;  // logarithmic: shows values above zero only
  std::string read{};
};

// One picture. Either all of its series have a z or none.
struct Figure {
  std::string title{};
  Axis x{}, y{}, z{};
  Axis right{};
  std::vector<Series> series{};
  // Labels below x = 0, 1, 2, ... instead of values.
  std::vector<std::string> names{};
  // Shown instead of series: grey or RGB, shared by all copies of the figure. Below it stands
  // `note`.
  std::shared_ptr<const Image> picture{};
  std::string note{};
  // Drawn one below the other over one x axis; the figure itself then has only a title.
  std::vector<Figure> panels{};
  bool saved = false;  // the present state is in a file of the program
  // identifies the figure in a run: they count from 0 in the order of their beginnings
  int index = 0;

  bool is_spatial() const { return !series.empty() && !series.front().z.empty(); }
  bool is_empty() const { return series.empty() && panels.empty() && picture == nullptr; }
};

// The unit in which values are shown: its text and the factor. Angles in degrees, lengths below 1 m
// in millimetres, masses below 1 kg in grams.
//
// largest  the largest absolute value that will be shown, SI.
struct PlotUnit {
  std::string text{};
  double factor = 1.0;
};
PlotUnit plot_unit(const std::string& si_unit, double largest);

// Whether a value can be drawn: finite, and small enough for computations.
bool is_drawable(double value);
// Whether a value can be drawn on this axis.
inline bool is_drawable(double value, const Axis& axis) {
  return is_drawable(value) && (!axis.log || value >= 1e-307);
}

// The smallest and the largest value that an axis shows, 0 and 1 if there is none (1 and 10 on a
// logarithmic axis); and the number of values.
struct Extent {
  double lower = 0.0, upper = 1.0;
  std::size_t count = 0;
};
Extent extent_of(const std::vector<const std::vector<double>*>& values, const Axis& axis = {});

// The smallest distance between x positions of bars, SI; 1 if there is only one.
double bar_pitch(const Figure& figure);

// Bars at one x position are side by side: the index of this series among them, their number, and
// the begin and end of its bar relative to that position.
struct BarSpan {
  double begin = 0.0, end = 0.0;  // SI
};
BarSpan bar_span(const Figure& figure, std::size_t series, double pitch);

}  // namespace armlet
