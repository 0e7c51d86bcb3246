#include "armlet/plot/svg.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armlet/core/xml.hpp"
#include "svg_parts.hpp"

namespace armlet {
namespace svg {

std::string axis_text(const Axis& axis, const PlotUnit& unit) {
  if (unit.text.empty()) return axis.label;
  return axis.label.empty() ? unit.text : fmt::format("{} ({})", axis.label, unit.text);
}

namespace {

constexpr double kLegendLetter = 12.0, kLegendRow = 20.0, kSwatch = 22.0;

std::string swatch(const Series& series, std::size_t index, Point at) {
  const std::size_t color = index % kSeriesColors;
  switch (series.kind) {
    case SeriesKind::kLine:
      return line({at.x, at.y - 4.0}, {at.x + 16.0, at.y - 4.0},
                  fmt::format("s s{}{}", color, index >= kSeriesColors ? " dash" : ""));
    case SeriesKind::kPoints:
      return fmt::format("<circle class=\"f{}\" cx=\"{}\" cy=\"{}\" r=\"3.5\"/>\n", color,
                         coordinate(at.x + 8.0), coordinate(at.y - 4.0));
    case SeriesKind::kBars:
      break;
  }
  return fmt::format("<path class=\"f{}\" d=\"M{} {}h10v10h-10z\"/>\n", color,
                     coordinate(at.x + 3.0), coordinate(at.y - 9.0));
}

// Names of the series in rows; leaves in `bottom` where they end.
std::string legend(const Figure& figure, double& bottom) {
  std::string out;
  double x = 20.0, y = bottom + 14.0;
  bool any = false;
  for (std::size_t i = 0; i < figure.series.size() && !figure.is_spatial(); ++i) {
    const Series& series = figure.series[i];
    if (series.label.empty()) continue;
    const std::string name = series.label + (series.right ? " (right)" : "");
    const double width = kSwatch + width_of(name, kLegendLetter) + 18.0;
    if (any && x + width > kWidth - 20.0) {
      x = 20.0;
      y += kLegendRow;
    }
    out += swatch(series, i, {x, y});
    out += text({x + kSwatch, y}, "start", "name", name);
    x += width;
    any = true;
  }
  if (any) bottom = y + 6.0;
  return out;
}

std::size_t left_out(const Figure& figure) {
  std::size_t count = 0;
  for (const Series& series : figure.series) {
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      const bool good = is_drawable(series.x[i]) && is_drawable(series.y[i]) &&
                        (series.z.empty() || is_drawable(series.z[i]));
      count += good ? 0 : 1;
    }
  }
  return count;
}

// One figure with its upper edge at 0; its height is left in `height`.
std::string figure_text(const Figure& figure, double& height) {
  double top = 10.0;
  std::string out;
  if (!figure.title.empty()) {
    out += text({0.5 * kWidth, top + 18.0}, "middle", "title", figure.title);
    top += 26.0;
  }
  out += legend(figure, top);
  height = top + (figure.is_spatial() ? kSpatialHeight : kFlatHeight);
  const Field outer{6.0, top, kWidth, height};
  out += figure.is_spatial() ? spatial_figure(figure, outer) : flat_figure(figure, outer);
  std::size_t points = 0;
  for (const Series& series : figure.series) points += series.x.size();
  const std::size_t missing = left_out(figure);
  if (points == missing) {
    out += text({0.5 * kWidth, 0.5 * (top + height)}, "middle", "note", "no values");
  }
  if (missing > 0) {
    out += text({kWidth - 18.0, height - 6.0}, "end", "note",
                fmt::format("{} value{} left out: not finite, or too large to draw", missing,
                            missing == 1 ? "" : "s"));
  }
  return out;
}

}  // namespace
}  // namespace svg

std::string to_svg(std::span<const Figure> figures) {
  std::string body;
  double top = 0.0;
  for (const Figure& figure : figures) {
    double height = 0.0;
    const std::string content = svg::figure_text(figure, height);
    body +=
        fmt::format("<g transform=\"translate(0 {})\">\n{}</g>\n", svg::coordinate(top), content);
    top += height + 8.0;
  }
  const std::string title = figures.empty() ? std::string() : figures.front().title;
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\" "
      "role=\"img\">\n<title>{2}</title>\n{3}<rect class=\"paper\" width=\"{0}\" "
      "height=\"{1}\"/>\n{4}</svg>\n",
      svg::coordinate(svg::kWidth), svg::coordinate(std::max(top, 40.0)),
      xml_escaped(title.empty() ? "plot" : title), svg::style(), body);
}

}  // namespace armlet
