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
