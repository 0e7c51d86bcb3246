#include "armlet/plot/svg.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armlet/core/xml.hpp"
#include "svg_plane.hpp"

namespace armlet {
namespace svg {

namespace {

// The printed form of units such as "m/s^2" and "N*s/m".
std::string printed(std::string_view unit) {
  std::string out;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const bool raises = unit[i] == '^' && i + 1 < unit.size();
    if (raises && unit[i + 1] == '2') {
      out += "\u00b2";
      ++i;
    } else if (raises && unit[i + 1] == '3') {
      out += "\u00b3";
      ++i;
    } else if (unit[i] == '*') {
      out += "\u00b7";
    } else {
      out += unit[i];
    }
  }
  return out;
}

constexpr double kLegendLetter = 12.0, kLegendRow = 20.0, kSwatch = 22.0;

std::string swatch(const Series& series, std::size_t index, Point at) {
  const std::size_t color = index % kSeriesColors;
  switch (series.kind) {
    case SeriesKind::kLine:
      return line({at.x, at.y - 4.0}, {at.x + 16.0, at.y - 4.0}, line_style(series, index));
    case SeriesKind::kPoints:
      return marker(index, {at.x + 8.0, at.y - 4.0}, 3.5);
    case SeriesKind::kBars:
      break;
  }
  return fmt::format("<path class=\"f{}\" d=\"M{} {}h10v10h-10z\"/>\n", color,
                     coordinate(at.x + 3.0), coordinate(at.y - 9.0));
}

std::size_t left_out(const Figure& figure) {
  std::size_t count = 0;
  for (const Figure& panel : figure.panels) count += left_out(panel);
  for (const Series& series : figure.series) {
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      const bool good = is_drawable(series.x[i], figure.x) &&
                        is_drawable(series.y[i], series.right ? figure.right : figure.y) &&
                        (series.z.empty() || is_drawable(series.z[i]));
      count += good ? 0 : 1;
    }
  }
  return count;
}

std::size_t point_count(const Figure& figure) {
  std::size_t count = 0;
  for (const Figure& panel : figure.panels) count += point_count(panel);
  for (const Series& series : figure.series) count += series.x.size();
  return count;
}

// One figure with its upper edge at 0; stores its height in `height`.
std::string figure_text(const Figure& figure, double& height) {
  double top = 10.0;
  std::string out;
  if (!figure.title.empty()) {
    out += text({0.5 * kWidth, top + 18.0}, "middle", "title", figure.title);
    top += 26.0;
  }
  if (figure.picture != nullptr) {
    height = top;
    return out + picture(figure, height);
  }
  if (figure.panels.empty()) {
    const double room = figure.is_spatial() ? kSpatialHeight : flat_height(figure);
    if (!figure.is_spatial()) {
      const Plane plane = plane_of(figure, {6.0, top, kWidth, top + room});
      out += legend(figure, plane.field.left, top);
    }
    height = top + room;
    const Field outer{6.0, top, kWidth, height};
    out +=
        figure.is_spatial() ? spatial_figure(figure, outer) : flat_figure(plane_of(figure, outer));
  } else {
    height = top;
    out += panels(figure, height);
  }
  const std::size_t missing = left_out(figure);
  if (point_count(figure) == missing) {
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

std::string axis_text(const Axis& axis, const PlotUnit& unit) {
  const std::string shown = printed(unit.text);
  if (shown.empty()) return axis.label;
  return axis.label.empty() ? shown : fmt::format("{} ({})", axis.label, shown);
}

std::string legend(const Figure& figure, double left, double& bottom, double indent) {
  std::string out;
  double x = left + indent, y = bottom + 14.0;
  bool any = false;
  for (std::size_t i = 0; i < figure.series.size() && !figure.is_spatial(); ++i) {
    const Series& series = figure.series[i];
    if (series.label.empty()) continue;
    const std::string name = series.label + (series.right ? " (right)" : "");
    const double width = kSwatch + width_of(name, kLegendLetter) + 18.0;
    if (any && x + width > kWidth - 20.0) {
      x = left;
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
