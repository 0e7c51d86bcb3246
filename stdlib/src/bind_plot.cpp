// Figures (language reference, sections 16 and 19).

#include <fmt/format.h>

#include <algorithm>

#include "armlet/plot/braille.hpp"
#include "armlet/plot/svg.hpp"
#include "armlet/stdlib/host.hpp"
#include "bind.hpp"

namespace armlet::bind {
namespace {

constexpr std::size_t kMaxValues = 5'000'000;  // of all figures of a program

std::string text_or_nothing(Slot s) {
  return s.o != nullptr ? std::string(text_value(s)) : std::string();
}

// The figure that plot adds to: the last one, or a first one without a title.
Figure& current(Host& host) {
  if (host.figures().empty()) host.figures().emplace_back();
  return host.figures().back();
}

std::size_t values_of(const Host& host) {
  std::size_t count = 0;
  for (const Figure& figure : host.figures()) {
    for (const Series& series : figure.series) {
      count += series.x.size() + series.y.size() + series.z.size();
    }
  }
  return count;
}

// Room for more values, as steps and as memory of the host.
bool has_room(Vm& vm, std::size_t more) {
  if (!charge_steps(vm, more)) return false;
  if (values_of(Host::of(vm)) + more <= kMaxValues) return true;
  static_cast<void>(failure(
      vm, "R0626", fmt::format("the figures of a program hold at most {} values", kMaxValues), 0,
      {}, "draw fewer points, for example every tenth"));
  return false;
}

std::string unit_phrase(const std::string& unit) { return unit.empty() ? "plain numbers" : unit; }

// Sets what an axis shows, or fails: a figure has one unit on each axis.
bool set_axis(Vm& vm, Axis& axis, bool is_new, const std::string& unit, const std::string& label,
              int parameter) {
  if (is_new) {
    axis = {label, unit};
  } else if (axis.unit != unit) {
    static_cast<void>(failure(vm, "R0626",
                              fmt::format("this figure shows {} on that axis, these values are {}",
                                          unit_phrase(axis.unit), unit_phrase(unit)),
                              parameter, {}, "begin another figure(\"...\") before"));
    return false;
  }
  return true;
}

// What people call the values of a unit, where nothing else is said.
std::string quantity_name(const std::string& unit) {
  if (unit == "s") return "time";
  if (unit == "rad") return "angle";
  return {};
}

// (x, y, label, axis, xUnit, yUnit)
template <SeriesKind kKind>
Signal add_series(Vm& vm, Slot* args) {
  enum { kX, kY, kLabel, kAxis, kXUnit, kYUnit };
  const auto x = reals_value(args[kX]), y = reals_value(args[kY]);
  if (x.size() != y.size()) return size_failure(vm, "x and y", x.size(), y.size());
  if (!has_room(vm, 2 * x.size())) return Signal::kFail;
  Figure& figure = current(Host::of(vm));
  if (figure.is_spatial()) {
    return failure(vm, "R0626", "this figure is drawn in space", kX, {},
                   "begin another figure(\"...\") before");
  }
  const std::string side = args[kAxis].o != nullptr ? text_or_nothing(args[kAxis]) : "left";
  if (side != "left" && side != "right") {
    return failure(vm, "R0626", fmt::format("there is no axis \"{}\"", side), kAxis,
                   "the axes are \"left\" and \"right\"");
  }
  const bool right = side == "right";
  const bool is_new = figure.series.empty();
  const bool new_side =
      std::ranges::none_of(figure.series, [&](const Series& s) { return s.right == right; });
  const std::string x_unit = text_or_nothing(args[kXUnit]), y_unit = text_or_nothing(args[kYUnit]);
  const bool is_map = kKind == SeriesKind::kPoints && x_unit == "m" && y_unit == "m";
  if (!set_axis(vm, figure.x, is_new, x_unit, is_map ? "x" : quantity_name(x_unit), kX) ||
      !set_axis(vm, right ? figure.right : figure.y, new_side, y_unit,
                is_map ? "y" : quantity_name(y_unit), kY)) {
    return Signal::kFail;
  }
  figure.series.push_back({.kind = kKind,
                           .label = text_or_nothing(args[kLabel]),
                           .x = {x.begin(), x.end()},
                           .y = {y.begin(), y.end()},
                           .right = right});
  return give_nothing();
}

// A figure of that title goes on; otherwise a new one begins.
Signal figure(Vm& vm, Slot* args) {
  std::vector<Figure>& figures = Host::of(vm).figures();
  const std::string title(text_value(args[0]));
  const auto found = std::ranges::find(figures, title, &Figure::title);
  if (found == figures.end()) {
    figures.push_back({.title = title});
  } else {
    std::rotate(found, found + 1, figures.end());
  }
  return give_nothing();
}

// (points, title, pointsUnit)
Signal scatter3(Vm& vm, Slot* args) {
  const auto points = items_value(args[0]);
  if (!has_room(vm, 3 * points.size())) return Signal::kFail;
  Series series{.kind = SeriesKind::kPoints};
  series.x.reserve(points.size());
  series.y.reserve(points.size());
  series.z.reserve(points.size());
  for (const Slot point : points) {
    const auto p = reals_value(point);
    if (p.size() != 3) {
      return failure(vm, "R0613", fmt::format("a point in space has 3 values, not {}", p.size()),
                     0);
    }
    series.x.push_back(p[0]);
    series.y.push_back(p[1]);
    series.z.push_back(p[2]);
  }
  const std::string unit = text_or_nothing(args[2]);
  Figure figure{
      .title = text_or_nothing(args[1]), .x = {"x", unit}, .y = {"y", unit}, .z = {"z", unit}};
  std::vector<Figure>& figures = Host::of(vm).figures();
  // A figure that was begun and is still empty becomes this one.
  if (!figures.empty() && figures.back().series.empty()) {
    if (figure.title.empty()) figure.title = figures.back().title;
    figures.pop_back();
  }
  figure.series.push_back(std::move(series));
  figures.push_back(std::move(figure));
  return give_nothing();
}

constexpr std::string_view kPictureEndings[] = {".svg", ".txt"};
constexpr FileKind kPicture{"a picture", kPictureEndings};

// (path, figure)
Signal save_plot(Vm& vm, Slot* args) {
  const Host& host = Host::of(vm);
  const std::string path(text_value(args[0]));
  std::vector<Figure> chosen = host.figures();
  if (args[1].o != nullptr) {
    const std::string_view title = text_value(args[1]);
    std::erase_if(chosen, [&](const Figure& f) { return f.title != title; });
    if (chosen.empty()) {
      return failure(vm, "R0626", fmt::format("there is no figure \"{}\"", title), 1);
    }
  }
  if (chosen.empty()) {
    return failure(vm, "R0626", "there is no figure to save", 0, {}, "call plot(x, y) before");
  }
  std::string content;
  if (path.ends_with(".svg")) {
    content = to_svg(chosen);
  } else if (path.ends_with(".txt")) {
    for (const Figure& each : chosen) content += to_braille(each) + "\n";
  } else {
    return failure(vm, "R0626", fmt::format("a picture is a .svg or .txt file, not \"{}\"", path),
                   0);
  }
  const auto saved = host.save_file(kPicture, path, content);
  if (saved.ok()) return give_nothing();
  return failure(vm, "R0626",
                 fmt::format("\"{}\" cannot be written: {}", path, saved.error().message), 0);
}

constexpr NativeFunction kFunctions[] = {
    {"figure", "(title: string)",
     "Begins a figure, or goes on with the one of that title; what is plotted next belongs to it.",
     "figure(\"speeds\")", figure},
    {"plot", "(x: D[], y: E[], label: string?, axis: string?, xUnit: string?, yUnit: string?)",
     "Draws a line through the points (x, y); label: its name in the legend, axis: \"left\" or "
     "\"right\", with a unit of its own. Units come from the types.",
     "plot([0s, 1s, 2s], [0deg, 30deg, 90deg], label: \"joint 1\")", add_series<SeriesKind::kLine>},
    {"scatter", "(x: D[], y: E[], label: string?, axis: string?, xUnit: string?, yUnit: string?)",
     "Draws points; lengths over lengths are drawn to one scale.",
     "scatter([100mm, 200mm], [0mm, 50mm])", add_series<SeriesKind::kPoints>},
    {"bars", "(x: D[], y: E[], label: string?, axis: string?, xUnit: string?, yUnit: string?)",
     "Draws a bar from zero to y at each x.", "bars([1.0, 2.0, 3.0], [4.0, 2.0, 5.0])",
     add_series<SeriesKind::kBars>},
    {"scatter3", "(points: D[][], title: string?, pointsUnit: string?)",
     "A figure of points [x, y, z] in space; the colour shows the height.",
     "scatter3([[100mm, 0mm, 50mm], [0mm, 100mm, 80mm]], title: \"reach\")", scatter3},
    {"savePlot", "(path: string, figure: string?)",
     "Saves all figures, or the one of that title, below the folder of the program: a picture "
     "(.svg) "
     "or text (.txt).",
     "plot([0s, 1s], [0deg, 30deg]); savePlot(\"speeds.svg\")", save_plot},
};

}  // namespace

std::span<const NativeFunction> plot_functions() { return kFunctions; }

}  // namespace armlet::bind
