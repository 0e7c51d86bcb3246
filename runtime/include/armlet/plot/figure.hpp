#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace armlet {

enum class SeriesKind { kLine, kPoints, kBars };

// "line", "points" or "bars".
std::string_view to_text(SeriesKind kind);

// Values that belong together, in SI units: x and y, and z in space. Elements of the same number
// make a point.
struct Series {
  SeriesKind kind = SeriesKind::kLine;
  std::string label{};
  std::vector<double> x{}, y{}, z{};
  bool right = false;  // y belongs to the axis on the right
};

// What an axis shows. `unit` is the SI unit of the values ("m", "rad/s"), empty for plain numbers;
// pictures choose deg, mm and so on themselves.
//
// read  the unit of values whose type has none, as the text of the program shows it; `unit` is
//       empty if numbers of which nothing is known are beside them.
struct Axis {
  std::string label{};
  std::string unit{};
  bool log = false;  // logarithmic: shows values above zero only
  std::string read{};
};

// One picture. Its series all have a z or none has.
struct Figure {
  std::string title{};
  Axis x{}, y{}, z{};
  Axis right{};
  std::vector<Series> series{};
  // Written below x = 0, 1, 2, ... instead of values.
  std::vector<std::string> names{};
  // Drawn one below the other over one x axis; the figure then has nothing of its own but a title.
  std::vector<Figure> panels{};
  bool saved = false;  // in a file of the program, as it is now
  int index = 0;       // names the figure in a run: they count from 0 as they are begun

  bool is_spatial() const { return !series.empty() && !series.front().z.empty(); }
  bool is_empty() const { return series.empty() && panels.empty(); }
};

// How people read values of a unit: the text to show and what to multiply by. Angles in degrees,
// lengths below 1 m in millimetres, masses below 1 kg in grams.
//
// largest  the largest absolute value that will be shown, SI.
struct PlotUnit {
  std::string text{};
  double factor = 1.0;
};
PlotUnit plot_unit(const std::string& si_unit, double largest);

// Whether a value can be drawn: finite, and small enough to reckon with.
bool is_drawable(double value);
// The same on this axis.
inline bool is_drawable(double value, const Axis& axis) {
  return is_drawable(value) && (!axis.log || value >= 1e-307);
}

// The least and the greatest value that an axis shows; 0 and 1 if there is none (1 and 10 where it
// is logarithmic). How many there are.
struct Extent {
  double lower = 0.0, upper = 1.0;
  std::size_t count = 0;
};
Extent extent_of(const std::vector<const std::vector<double>*>& values, const Axis& axis = {});

// The least distance between places of bars, SI; 1 if there is only one.
double bar_pitch(const Figure& figure);

// Bars at one place stand side by side: which of how many this series is, and where its bar begins
// and ends beside its place.
struct BarSpan {
  double begin = 0.0, end = 0.0;  // SI
};
BarSpan bar_span(const Figure& figure, std::size_t series, double pitch);

}  // namespace armlet
