#include "armlet/plot/braille.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "armlet/plot/ticks.hpp"
#include "dot_character.hpp"
#include "picture_text.hpp"

namespace armlet {
namespace {

// Characters of 2 x 4 dots.
class Dots {
 public:
  Dots(int columns, int rows)
      : columns_(columns),
        rows_(rows),
        bits_(static_cast<std::size_t>(columns * rows), 0),
        series_(bits_.size(), -1) {}

  int width() const { return 2 * columns_; }
  int height() const { return 4 * rows_; }

  void set(int x, int y, int series) {
    if (x < 0 || x >= width() || y < 0 || y >= height()) return;
    const std::size_t cell = static_cast<std::size_t>((y / 4) * columns_ + x / 2);
    bits_[cell] = static_cast<std::uint8_t>(bits_[cell] | kDotBits[y % 4][x % 2]);
    series_[cell] = series;
  }

  void segment(double x0, double y0, double x1, double y1, int series) {
    const int steps = 1 + static_cast<int>(std::max(std::abs(x1 - x0), std::abs(y1 - y0)));
    for (int k = 0; k <= steps; ++k) {
      const double s = static_cast<double>(k) / steps;
      set(static_cast<int>(std::floor(x0 + s * (x1 - x0))),
          static_cast<int>(std::floor(y0 + s * (y1 - y0))), series);
    }
  }

  std::string row(int r, bool color) const {
    constexpr int kColors[] = {36, 33, 32, 35, 34, 31, 37};
    std::string out;
    int now = -1;
    for (int c = 0; c < columns_; ++c) {
      const std::size_t cell = static_cast<std::size_t>(r * columns_ + c);
      if (color && bits_[cell] != 0 && series_[cell] != now) {
        now = series_[cell];
        out += fmt::format("\x1b[{}m", kColors[now % 7]);
      }
      append_dots(out, bits_[cell]);
    }
    if (now >= 0) out += "\x1b[0m";
    return out;
  }

 private:
  int columns_, rows_;
  std::vector<std::uint8_t> bits_;
  std::vector<int> series_;
};

struct Scale {
  PlotUnit unit;
  Ticks ticks;
};

// In space, x and z are drawn, the view from the front.
const std::vector<double>& upward(const Figure& figure, const Series& series) {
  return figure.is_spatial() ? series.z : series.y;
}

enum class Side { kBelow, kLeft, kRight };

const Axis& axis_of(const Figure& figure, Side side) {
  return side == Side::kBelow   ? figure.x
         : side == Side::kRight ? figure.right
         : figure.is_spatial()  ? figure.z
                                : figure.y;
}

// beside  an axis whose ticks are at the same heights, if there is one.
Scale scale_of(const Figure& figure, Side side, int wanted, const Ticks* beside = nullptr) {
  std::vector<const std::vector<double>*> lists;
  bool bars = false;
  for (const Series& series : figure.series) {
    if (side != Side::kBelow && series.right != (side == Side::kRight)) continue;
    lists.push_back(side == Side::kBelow ? &series.x : &upward(figure, series));
    bars = bars || (side != Side::kBelow && series.kind == SeriesKind::kBars);
  }
  const Axis& axis = axis_of(figure, side);
  Scale scale;
  if (side == Side::kBelow && !figure.names.empty()) {
    scale.ticks = make_name_ticks(figure.names);
    return scale;
  }
  Extent extent = extent_of(lists, axis);
  if (bars && !axis.log) {
    extent.lower = std::min(extent.lower, 0.0);
    extent.upper = std::max(extent.upper, 0.0);
  }
  scale.unit = plot_unit(axis.unit, std::max(std::abs(extent.lower), std::abs(extent.upper)));
  const double lower = extent.lower * scale.unit.factor, upper = extent.upper * scale.unit.factor;
  const bool degrees = scale.unit.text == "deg";
  if (axis.log) {
    scale.ticks = make_log_ticks(lower, upper, wanted);
  } else if (beside != nullptr && !beside->log) {
    scale.ticks = make_parallel_ticks(lower, upper, *beside, degrees);
  } else {
    scale.ticks = make_ticks(lower, upper, wanted, degrees, true);
  }
  return scale;
}

void draw(Dots& dots, const Figure& figure, const Scale& x, const Scale& left,
          const Scale& on_right) {
  const auto right = [&](double v) {
    return x.ticks.position(v * x.unit.factor) * (dots.width() - 1) + 0.5;
  };
  const double pitch = bar_pitch(figure);
  for (std::size_t s = 0; s < figure.series.size(); ++s) {
    const Series& series = figure.series[s];
    const BarSpan span = bar_span(figure, s, pitch);
    const std::vector<double>& up = upward(figure, series);
    const int index = static_cast<int>(s);
    const Scale& y = series.right ? on_right : left;
    const Axis& upright = axis_of(figure, series.right ? Side::kRight : Side::kLeft);
    const auto shows = [&](std::size_t i) {
      return is_drawable(series.x[i], figure.x) && is_drawable(up[i], upright);
    };
    const auto down = [&](double v) {
      return (1.0 - y.ticks.position(v * y.unit.factor)) * (dots.height() - 1) + 0.5;
    };
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (!shows(i)) continue;
      const double px = right(series.x[i]), py = down(up[i]);
      if (series.kind == SeriesKind::kLine && i > 0 && shows(i - 1)) {
        dots.segment(right(series.x[i - 1]), down(up[i - 1]), px, py, index);
      } else if (series.kind == SeriesKind::kBars) {
        const double ground = upright.log ? dots.height() - 1 : down(0.0);
        const double end = right(series.x[i] + span.end);
        double column = right(series.x[i] + span.begin);
        do dots.segment(column, ground, column, py, index);
        while (++column < end);
      } else {
        dots.set(static_cast<int>(std::floor(px)), static_cast<int>(std::floor(py)), index);
      }
    }
  }
}

std::string unit_text(const Axis& axis, const Scale& scale) {
  if (scale.unit.text.empty()) return axis.label;
  return axis.label.empty() ? scale.unit.text : fmt::format("{} ({})", axis.label, scale.unit.text);
}

// Number of visible letters of a text.
int letters(const std::string& text) {
  int count = 0;
  for (const char c : text) count += (static_cast<unsigned char>(c) & 0xc0U) != 0x80U ? 1 : 0;
  return count;
}

// The values below the plot, each under its position, as many as fit.
std::string values_below(const Scale& x, int columns, std::size_t indent) {
  std::string out(indent + 1, ' ');
  const std::size_t start = out.size();
  std::size_t used = start;  // letters of the line
  for (std::size_t i = 0; i < x.ticks.at.size(); ++i) {
    const std::string& label = x.ticks.labels[i];
    const double middle = x.ticks.position(x.ticks.at[i]) * columns;
    const double width = letters(label);
    const double begin =
        std::clamp(middle - 0.5 * width, 0.0, std::max(0.0, static_cast<double>(columns) - width));
    const std::size_t at = start + static_cast<std::size_t>(begin);
    if (i > 0 && at < used + 1) continue;
    out.append(at - used, ' ');
    out += label;
    used = at + static_cast<std::size_t>(width);
  }
  return out + '\n';
}

// The labels of the series in one line.
std::string legend(const Figure& figure, bool color) {
  constexpr int kColors[] = {36, 33, 32, 35, 34, 31, 37};
  std::string out;
  for (std::size_t s = 0; s < figure.series.size(); ++s) {
    const std::string& label = figure.series[s].label;
    if (label.empty()) continue;
    if (!out.empty()) out += "  ";
    out += color ? fmt::format("\x1b[{}m{}\x1b[0m", kColors[s % 7], label) : label;
  }
  return out.empty() ? out : out + '\n';
}

// Rows of dots, each after the axis value at its height.
std::string field_text(const Dots& dots, const Ticks& ticks, int rows, int widest, bool color) {
  std::string out;
  for (int r = 0; r < rows; ++r) {
    std::string value;
    for (std::size_t i = 0; i < ticks.at.size(); ++i) {
      const double at = (1.0 - ticks.position(ticks.at[i])) * (dots.height() - 1);
      if (static_cast<int>(at / 4.0) == r) value = ticks.labels[i];
    }
    value.insert(0, static_cast<std::size_t>(widest - letters(value)), ' ');
    std::string row = value + " \u2502" + dots.row(r, color);
    while (row.back() == ' ') row.pop_back();
    out += row + '\n';
  }
  return out;
}

std::string panels_text(const Figure& figure, int columns, int rows, bool color) {
  std::string out = figure.title.empty() ? std::string() : figure.title + '\n';
  for (const Figure& panel : figure.panels)
    out += to_braille(panel, columns, std::max(8, rows / 2), color);
  return out;
}

}  // namespace

std::string to_braille(const Figure& figure, int columns, int rows, bool color) {
  columns = std::clamp(columns, 8, 400);
  rows = std::clamp(rows, 4, 200);
  if (!figure.panels.empty()) return panels_text(figure, columns, rows, color);
  if (figure.picture != nullptr) return picture_text(figure, columns, 2 * rows, color);
  const Scale x = scale_of(figure, Side::kBelow, std::clamp(columns / 10, 2, 8));
  const Scale y = scale_of(figure, Side::kLeft, std::clamp(rows / 4, 2, 8));
  const Scale right = scale_of(figure, Side::kRight, std::clamp(rows / 4, 2, 8), &y.ticks);
  Dots dots(columns, rows);
  draw(dots, figure, x, y, right);
  int widest = 0;
  for (const std::string& label : y.ticks.labels) widest = std::max(widest, letters(label));
  const auto indent = static_cast<std::size_t>(widest) + 1;
  std::string out = figure.title.empty() ? std::string() : figure.title + '\n';
  out += legend(figure, color);
  if (const std::string name = unit_text(axis_of(figure, Side::kLeft), y); !name.empty())
    out += name + '\n';
  if (std::ranges::any_of(figure.series, &Series::right)) {
    out += fmt::format("on the right {} to {} {}\n", right.ticks.labels.front(),
                       right.ticks.labels.back(), unit_text(figure.right, right));
  }
  out += field_text(dots, y.ticks, rows, widest, color);
  out += std::string(indent, ' ') + "\u2514";
  for (int c = 0; c < columns; ++c) out += "\u2500";
  out += '\n' + values_below(x, columns, indent);
  if (const std::string name = unit_text(figure.x, x); !name.empty())
    out += std::string(indent + 1, ' ') + name + '\n';
  return out;
}

}  // namespace armlet
