#include "armlet/plot/figure.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "armlet/math/angles.hpp"

namespace armlet {

std::string_view to_text(SeriesKind kind) {
  switch (kind) {
    case SeriesKind::kLine:
      return "line";
    case SeriesKind::kPoints:
      return "points";
    case SeriesKind::kBars:
      break;
  }
  return "bars";
}

bool is_drawable(double value) { return std::isfinite(value) && std::abs(value) <= 1e304; }

PlotUnit plot_unit(const std::string& si_unit, double largest) {
  const std::string_view rest = si_unit;
  if (rest == "rad" || rest.starts_with("rad/")) {
    return {"deg" + si_unit.substr(3), rad_to_deg(1.0)};
  }
  if ((rest == "m" || rest.starts_with("m/")) && largest < 1.0) {
    return {"mm" + si_unit.substr(1), 1000.0};
  }
  if (rest == "kg" && largest < 1.0) return {"g", 1000.0};
  return {si_unit, 1.0};
}

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

BarSpan bar_span(const Figure& figure, std::size_t series, double pitch) {
  std::size_t count = 0, before = 0;
  for (std::size_t s = 0; s < figure.series.size(); ++s) {
    if (figure.series[s].kind != SeriesKind::kBars) continue;
    before += s < series ? 1 : 0;
    ++count;
  }
  // width of a group relative to the pitch, of a bar to its part of the group
  constexpr double kGroup = 0.8, kBar = 0.94;
  const double width = kGroup * pitch / static_cast<double>(std::max<std::size_t>(count, 1));
  const double begin = -0.5 * kGroup * pitch + width * static_cast<double>(before);
  return {begin, begin + kBar * width};
}

Extent extent_of(const std::vector<const std::vector<double>*>& values, const Axis& axis) {
  Extent extent;
  if (axis.log) extent = {1.0, 10.0};
  for (const std::vector<double>* list : values) {
    for (const double value : *list) {
      if (!is_drawable(value, axis)) continue;
      if (extent.count++ == 0) extent.lower = extent.upper = value;
      extent.lower = std::min(extent.lower, value);
      extent.upper = std::max(extent.upper, value);
    }
  }
  return extent;
}

}  // namespace armlet
