// Grid, values and names of the axes of a figure in the plane.

#include <fmt/format.h>

#include <algorithm>

#include "svg_plane.hpp"

namespace armlet::svg {
namespace {

constexpr std::size_t kLongestName = 20;  // letters of a rotated one

std::string name_beside(double x, const Field& field, int turn, const std::string& name) {
  if (name.empty()) return {};
  const double y = 0.5 * (field.top + field.bottom);
  return text({x, y}, "middle", "axis", name,
              fmt::format(" transform=\"rotate({} {} {})\"", turn, coordinate(x), coordinate(y)));
}

// Values and name of the axis on the right.
std::string right_axis(const Plane& plane) {
  if (!plane.has_right()) return {};
  const Field& field = plane.field;
  const Ticks& ticks = plane.right.ticks;
  std::string out = line({field.right, field.top}, {field.right, field.bottom}, "frame");
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    const double y = field.bottom - field.height() * ticks.position(ticks.at[i]);
    out += line({field.right, y}, {field.right + 4.0, y}, "frame");
    out += text({field.right + 8.0, y + 4.0}, "start", "tick", with_minus(ticks.labels[i]));
  }
  // A name that is rotated to the right rises to the right.
  return out +
         name_beside(kWidth - 13.0, field, 90, axis_text(plane.figure.right, plane.right.unit));
}

// All names if there are few, otherwise every k-th name.
std::string names_below(const Plane& plane) {
  const std::vector<std::string>& names = plane.figure.names;
  const Field& field = plane.field;
  const double least = plane.slanted_names ? 16.0 : 1.0;  // px between two
  const auto stride = static_cast<std::size_t>(
      std::max(1.0, least * static_cast<double>(names.size()) / field.width() + 0.999));
  std::string out;
  for (std::size_t i = 0; i < names.size(); i += stride) {
    const double x = plane.x.at(static_cast<double>(i));
    if (!plane.slanted_names) {
      out += text({x, field.bottom + 17.0}, "middle", "tick", names[i]);
      continue;
    }
    const double y = field.bottom + 14.0;
    out += text({x, y}, "end", "tick", shortened(names[i]),
                fmt::format(" transform=\"rotate(-40 {} {})\"", coordinate(x), coordinate(y)));
  }
  return out;
}

std::string x_axis(const Plane& plane) {
  const Field& field = plane.field;
  const Ticks& ticks = plane.x.ticks;
  std::string out;
  if (!plane.figure.names.empty()) return plane.named_below ? names_below(plane) : out;
  const auto grid_line = [&](double value, std::string_view css) {
    const double x = field.left + field.width() * ticks.position(value);
    out += line({x, field.top}, {x, field.bottom}, css);
    return x;
  };
  for (const double value : ticks.minor) grid_line(value, "grid minor");
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    const double x = grid_line(ticks.at[i], "grid");
    if (plane.named_below)
      out += text({x, field.bottom + 17.0}, "middle", "tick", with_minus(ticks.labels[i]));
  }
  const std::string name = axis_text(plane.figure.x, plane.x.unit);
  if (!name.empty() && plane.named_below) {
    out += text({0.5 * (field.left + field.right), field.bottom + 37.0}, "middle", "axis", name);
  }
  return out;
}

std::string y_axis(const Plane& plane) {
  const Field& field = plane.field;
  const Ticks& ticks = plane.y.ticks;
  std::string out;
  const auto grid_line = [&](double value, std::string_view css) {
    const double y = field.bottom - field.height() * ticks.position(value);
    out += line({field.left, y}, {field.right, y}, css);
    return y;
  };
  for (const double value : ticks.minor) grid_line(value, "grid minor");
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    const double y = grid_line(ticks.at[i], "grid");
    out += text({field.left - 7.0, y + 4.0}, "end", "tick", with_minus(ticks.labels[i]));
  }
  return out + name_beside(plane.name_at, field, -90, axis_text(plane.figure.y, plane.y.unit));
}

}  // namespace

std::string shortened(const std::string& name) {
  std::size_t letters = 0;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool begins = (static_cast<unsigned char>(name[i]) & 0xc0U) != 0x80U;
    if (begins && ++letters > kLongestName) return name.substr(0, i) + "\u2026";
  }
  return name;
}

std::string axes(const Plane& plane) {
  const Field& field = plane.field;
  std::string out = x_axis(plane) + y_axis(plane);
  // The zero line is emphasised if there are values below it.
  if (plane.y.ticks.lower < 0.0 && plane.y.ticks.upper > 0.0) {
    const double y = plane.y.at(0.0);
    out += line({field.left, y}, {field.right, y}, "zero");
  }
  out += fmt::format("<path class=\"frame\" d=\"M{} {}V{}H{}\"/>\n", coordinate(field.left),
                     coordinate(field.top), coordinate(field.bottom), coordinate(field.right));
  return out + right_axis(plane);
}

}  // namespace armlet::svg
