// Panels of one figure: fields of the same width one below the other, over one x axis.

#include <algorithm>

#include "svg_plane.hpp"

namespace armlet::svg {
namespace {

constexpr double kTitleRoom = 20.0, kNamesRoom = 38.0;  // px above and below

std::vector<std::string> labels_of(const Figure& panel) {
  std::vector<std::string> labels;
  for (const Series& series : panel.series) labels.push_back(series.label);
  return labels;
}

bool have_one_legend(const Figure& figure) {
  return std::ranges::all_of(figure.panels, [&](const Figure& panel) {
    return labels_of(panel) == labels_of(figure.panels.front());
  });
}

}  // namespace

std::string panels(const Figure& figure, double& bottom) {
  std::string out;
  const bool one_legend = have_one_legend(figure);
  Extent x{.lower = 0.0, .upper = 1.0};
  PanelFrame frame{.x = &x, .left = 0.0, .right = kWidth};
  for (const Figure& panel : figure.panels) {
    const Extent own = x_extent(panel);
    x = {x.count == 0 ? own.lower : std::min(x.lower, own.lower),
         x.count == 0 ? own.upper : std::max(x.upper, own.upper), x.count + own.count};
    const Plane plane = plane_of(panel, {6.0, 0.0, kWidth, kPanelHeight}, {.x = &own});
    frame.left = std::max(frame.left, plane.field.left);
    frame.right = std::min(frame.right, plane.field.right);
  }
  if (one_legend) out += legend(figure.panels.front(), frame.left, bottom);
  for (const Figure& panel : figure.panels) {
    frame.named_below = &panel == &figure.panels.back();
    out += text({frame.left, bottom + 18.0}, "start", "panel", panel.title);
    double legend_bottom = bottom + 4.0;
    if (!one_legend && panel.series.size() > 1)
      out += legend(panel, frame.left, legend_bottom, width_of(panel.title, kLetter) + 24.0);
    bottom = std::max(bottom + kTitleRoom, legend_bottom);
    const double height = kPanelHeight + (frame.named_below ? kNamesRoom : 0.0);
    out += flat_figure(plane_of(panel, {6.0, bottom, kWidth, bottom + height}, frame));
    bottom += height;
  }
  return out;
}

}  // namespace armlet::svg
