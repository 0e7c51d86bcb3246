// Figures: beginning them, points in the plane and in space, files (language reference, sections 16
// and 19).

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "armlet/interpreter/work.hpp"
#include "armlet/plot/braille.hpp"
#include "armlet/plot/svg.hpp"
#include "plots.hpp"

namespace armlet::bind {
namespace {

// (x, y, label, axis, xUnit, yUnit)
template <SeriesKind kKind>
Signal plot_values(Vm& vm, Slot* args) {
  enum { kX, kY, kLabel, kAxis, kXUnit, kYUnit };
  const auto x = reals_value(args[kX]), y = reals_value(args[kY]);
  if (x.size() != y.size()) return size_failure(vm, "x and y", x.size(), y.size());
  if (!has_room(vm, 2 * x.size())) return Signal::kFail;
  Series series{.kind = kKind,
                .label = text_or_nothing(args[kLabel]),
                .x = {x.begin(), x.end()},
                .y = {y.begin(), y.end()}};
  const PlotUnits units{text_or_nothing(args[kXUnit]), text_or_nothing(args[kYUnit]), kX, kY};
  if (!read_side(vm, args[kAxis], kAxis, series.right) ||
      !add_series(vm, current_figure(Host::of(vm)), std::move(series), units)) {
    return Signal::kFail;
  }
  return give_nothing();
}

// Where the bar of each name stands: below the same name of the figure, or behind all that are
// there. A name that is given twice has two places.
std::vector<double> places_of(std::span<const Slot> given, std::vector<std::string>& names) {
  std::map<std::string, std::vector<std::size_t>, std::less<>> known;
  for (std::size_t i = 0; i < names.size(); ++i) known[names[i]].push_back(i);
  std::map<std::string, std::size_t, std::less<>> seen;
  std::vector<double> places;
  for (const Slot slot : given) {
    std::string name(text_value(slot));
    std::vector<std::size_t>& at = known[name];
    std::size_t& which = seen[name];
    if (which == at.size()) {
      at.push_back(names.size());
      names.push_back(std::move(name));
    }
    places.push_back(static_cast<double>(at[which++]));
  }
  return places;
}

// (names, y, label, axis, yUnit)
Signal named_bars(Vm& vm, Slot* args) {
  enum { kNames, kY, kLabel, kAxis, kYUnit };
  const auto given = items_value(args[kNames]);
  const auto y = reals_value(args[kY]);
  if (given.size() != y.size()) return size_failure(vm, "names and y", given.size(), y.size());
  if (!has_room(vm, 2 * y.size())) return Signal::kFail;
  Figure& figure = current_figure(Host::of(vm));
  if ((figure.names.empty() && !figure.series.empty()) || figure.x.log) {
    return failure(vm, "R0626", "this figure has numbers below it, not names", kNames, {},
                   "begin another figure(\"...\") before");
  }
  Series series{
      .kind = SeriesKind::kBars, .label = text_or_nothing(args[kLabel]), .y = {y.begin(), y.end()}};
  std::vector<std::string> names = figure.names;
  series.x = places_of(given, names);
  const PlotUnits units{{}, text_or_nothing(args[kYUnit]), kNames, kY};
  if (!read_side(vm, args[kAxis], kAxis, series.right) ||
      !add_series(vm, figure, std::move(series), units)) {
    return Signal::kFail;
  }
  figure.names = std::move(names);
  return give_nothing();
}

// Whether what a figure holds can be shown on axes that become logarithmic. False: the failure is
// set.
bool check_log_of(Vm& vm, const Figure& figure) {
  for (const Figure& panel : figure.panels) {
    if (!check_log_of(vm, panel)) return false;
  }
  return std::ranges::all_of(figure.series, [&](const Series& series) {
    return check_log(vm, figure.x, series.x, 'x', 1) &&
           check_log(vm, series.right ? figure.right : figure.y, series.y, 'y', 1);
  });
}

void set_log(Figure& figure, bool x, bool y) {
  figure.x.log = x;
  figure.y.log = figure.right.log = y;
  for (Figure& panel : figure.panels) set_log(panel, x, y);
}

// (title, log): a figure of that title goes on; otherwise a new one begins.
Signal figure(Vm& vm, Slot* args) {
  std::vector<Figure>& figures = Host::of(vm).figures();
  const std::string title(text_value(args[0]));
  const std::string log = text_or_nothing(args[1]);
  const bool x = log == "x" || log == "xy" || log == "yx";
  const bool y = log == "y" || log == "xy" || log == "yx";
  if (args[1].o != nullptr && !x && !y && !log.empty()) {
    return failure(vm, "R0626", fmt::format("there is no logarithmic axis \"{}\"", log), 1,
                   "log: is \"x\", \"y\" or \"xy\"");
  }
  const auto found = std::ranges::find(figures, title, &Figure::title);
  if (found == figures.end()) {
    figures.push_back({.title = title});
  } else {
    std::rotate(found, found + 1, figures.end());
  }
  Figure& current = figures.back();
  if (args[1].o == nullptr || (current.x.log == x && current.y.log == y)) return give_nothing();
  Figure changed = current;
  set_log(changed, x, y);
  if (x && (changed.is_spatial() || !changed.names.empty())) {
    return failure(vm, "R0626", "only an axis of numbers in the plane can be logarithmic", 1);
  }
  if (!charge_steps(vm, changed.series.size()) || !check_log_of(vm, changed)) return Signal::kFail;
  changed.saved = false;
  current = std::move(changed);
  return give_nothing();
}

// A figure of a series in space. A figure that was begun and is still empty becomes this one.
void add_cloud(Host& host, Series series, std::string title, const std::string& unit) {
  Figure figure{.title = std::move(title), .x = {"x", unit}, .y = {"y", unit}, .z = {"z", unit}};
  std::vector<Figure>& figures = host.figures();
  if (!figures.empty() && figures.back().is_empty()) {
    if (figure.title.empty()) figure.title = figures.back().title;
    figures.pop_back();
  }
  figure.series.push_back(std::move(series));
  figures.push_back(std::move(figure));
}

Signal not_spatial(Vm& vm, std::size_t values) {
  return failure(vm, "R0613", fmt::format("a point in space has 3 values, not {}", values), 0);
}

// (points, title, pointsUnit)
Signal scatter_lists(Vm& vm, Slot* args) {
  const auto points = items_value(args[0]);
  if (!has_room(vm, 3 * points.size())) return Signal::kFail;
  Series series{.kind = SeriesKind::kPoints};
  for (std::vector<double>* part : {&series.x, &series.y, &series.z}) part->reserve(points.size());
  for (const Slot point : points) {
    const auto p = reals_value(point);
    if (p.size() != 3) return not_spatial(vm, p.size());
    series.x.push_back(p[0]);
    series.y.push_back(p[1]);
    series.z.push_back(p[2]);
  }
  add_cloud(Host::of(vm), std::move(series), text_or_nothing(args[1]), text_or_nothing(args[2]));
  return give_nothing();
}

// (points, title, unit)
Signal scatter_matrix(Vm& vm, Slot* args) {
  const MatrixObj& points = matrix_value(args[0]);
  if (points.cols != 3) return not_spatial(vm, points.cols);
  if (!has_room(vm, std::size_t{3} * points.rows)) return Signal::kFail;
  Series series{.kind = SeriesKind::kPoints};
  for (std::size_t i = 0; i < points.rows; ++i) {
    const double* p = points.data() + 3 * i;
    series.x.push_back(p[0]);
    series.y.push_back(p[1]);
    series.z.push_back(p[2]);
  }
  add_cloud(Host::of(vm), std::move(series), text_or_nothing(args[1]), text_or_nothing(args[2]));
  return give_nothing();
}

constexpr std::string_view kPictureEndings[] = {".svg", ".txt"};
constexpr FileKind kPicture{"a picture", kPictureEndings};

std::size_t points_of(const Figure& figure) {
  std::size_t count = 0;
  for (const Figure& panel : figure.panels) count += points_of(panel);
  for (const Series& series : figure.series) count += series.x.size();
  return count;
}

// (path, figure)
Answer<void> save_plot(Vm& vm, std::string_view given_path,
                       std::optional<std::string_view> figure) {
  Host& host = Host::of(vm);
  const std::string path(given_path);
  std::vector<Figure*> chosen;
  for (Figure& figure : host.figures()) {
    if (!figure || figure.title == *figure) chosen.push_back(&figure);
  }
  if (chosen.empty() && figure) {
    return failure(vm, "R0626", fmt::format("there is no figure \"{}\"", *figure), 1);
  }
  if (chosen.empty()) {
    return failure(vm, "R0626", "there is no figure to save", 0, {}, "call plot(x, y) before");
  }
  const bool as_text = path.ends_with(".txt");
  if (!as_text && !path.ends_with(".svg")) {
    return failure(vm, "R0626", fmt::format("a picture is a .svg or .txt file, not \"{}\"", path),
                   0);
  }
  constexpr std::uint64_t kCost = 256;  // of a point on its way into a picture
  std::vector<Figure> shown;
  for (const Figure* each : chosen) {
    if (!charge_work(vm, kCost * points_of(*each))) return Failed{};
    shown.push_back(*each);
  }
  std::string content;
  if (!as_text) content = to_svg(shown);
  for (std::size_t i = 0; as_text && i < shown.size(); ++i) content += to_braille(shown[i]) + "\n";
  const auto saved = host.save_file(kPicture, path, content);
  if (!saved.ok()) {
    return failure(vm, "R0626",
                   fmt::format("\"{}\" cannot be written: {}", path, saved.error().message), 0);
  }
  for (Figure* each : chosen) each->saved = true;
  return {};
}

constexpr std::string_view kValues =
    "(x: D[], y: E[], label: string?, axis: string?, xUnit: string?, yUnit: string?)";

constexpr NativeFunction kPlotFunctions[] = {
    {"figure", "(title: string, log: string?)",
     "Begins a figure, or goes on with the one of that title; what is plotted next belongs to it. "
     "log: \"y\", \"x\" or \"xy\" makes these axes logarithmic, which show values above zero only.",
     "figure(\"speeds\")", figure},
    {"plot", kValues,
     "Draws a line through the points (x, y); label: its name in the legend, axis: \"left\" or "
     "\"right\", with a unit of its own. Units come from the types.",
     "plot([0s, 1s, 2s], [0deg, 30deg, 90deg], label: \"joint 1\")",
     plot_values<SeriesKind::kLine>},
    {"scatter", kValues, "Draws points; lengths over lengths are drawn to one scale.",
     "scatter([100mm, 200mm], [0mm, 50mm])", plot_values<SeriesKind::kPoints>},
    {"bars", kValues, "Draws a bar from zero to y at each x.",
     "bars([1.0, 2.0, 3.0], [4.0, 2.0, 5.0])", plot_values<SeriesKind::kBars>},
    {"bars", "(names: string[], y: E[], label: string?, axis: string?, yUnit: string?)",
     "Draws a bar for each name, which stands below it. Further bars of the figure stand beside "
     "those of the same name.",
     "bars([\"base\", \"shoulder\", \"elbow\"], [12Nm, 31Nm, 8Nm], label: \"no load\")",
     named_bars},
    {"scatter3", "(points: D[][], title: string?, pointsUnit: string?)",
     "A figure of points [x, y, z] in space; the colour shows the height.",
     "scatter3([[100mm, 0mm, 50mm], [0mm, 100mm, 80mm]], title: \"reach\")", scatter_lists},
    {"scatter3", "(points: matrix, title: string?, unit: string?)",
     "The same for the rows of a matrix of three columns; unit: what its numbers are in SI, such "
     "as \"m\".",
     "scatter3([0.1, 0, 0.05; 0, 0.1, 0.08], title: \"reach\", unit: \"m\")", scatter_matrix},
    def<save_plot>(
        "savePlot(path: string, figure: string?)",
        "Saves all figures, or the one of that title, below the folder of the program: a picture "
        "(.svg) "
        "or text (.txt).",
        "plot([0s, 1s], [0deg, 30deg]); savePlot(\"speeds.svg\")"),
};

}  // namespace

std::span<const NativeFunction> plot_functions() { return kPlotFunctions; }

}  // namespace armlet::bind
