// Figures: starting them, points in the plane and in space, files (language reference, sections 16
// and 19).

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "armlet/interpreter/work.hpp"
#include "armlet/plot/braille.hpp"
#include "armlet/plot/svg.hpp"
#include "plot/plots.hpp"
#include "rules/rules_settings.hpp"
#include "values/setting_words.hpp"

namespace armlet::bind {
namespace {

// Adds a series to the current figure of the program.
Answer<void> add_to_current(Vm& vm, Series series, OptionalText axis, PlotUnits units,
                            OptionalText read) {
  const auto right = is_right(vm, axis, at("axis"));
  if (!right) return Failed{};
  series.right = *right;
  units.is_side_given = axis.has_value();
  const auto each = read_units(vm, read, units.y, series.y.size());
  return add_by_unit(vm, current_figure(Host::of(vm)), std::move(series), std::move(units), each);
}

template <SeriesKind kKind>
Answer<void> plot_values(Vm& vm, std::span<const double> x, std::span<const double> y,
                         OptionalText label, OptionalText axis, OptionalText x_unit,
                         OptionalText y_unit, OptionalText y_units) {
  if (x.size() != y.size()) return size_failure(vm, "x and y", x.size(), y.size());
  if (!make_room(vm, 2 * x.size())) return Failed{};
  Series series{.kind = kKind,
                .label = text_or_nothing(label),
                .x = {x.begin(), x.end()},
                .y = {y.begin(), y.end()}};
  const PlotUnits units{text_or_nothing(x_unit), text_or_nothing(y_unit), at("x"), at("y")};
  if (!add_to_current(vm, std::move(series), axis, units, y_units)) return Failed{};
  return figure_changed(vm);
}

// The position of the bar of each name: that of the same name in the figure, or after the last one.
// A name that is given twice has two positions.
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

Answer<void> named_bars(Vm& vm, std::span<const Slot> given, std::span<const double> y,
                        OptionalText label, OptionalText axis, OptionalText y_unit,
                        OptionalText y_units) {
  if (given.size() != y.size()) return size_failure(vm, "names and y", given.size(), y.size());
  if (!make_room(vm, 2 * y.size())) return Failed{};
  Figure& figure = current_figure(Host::of(vm));
  if ((figure.names.empty() && !figure.series.empty()) || figure.x.log) {
    return failure(vm, "R0626", "this figure has numbers below it, not names", at("names"), {},
                   "begin another figure(\"...\") before");
  }
  Series series{
      .kind = SeriesKind::kBars, .label = text_or_nothing(label), .y = {y.begin(), y.end()}};
  std::vector<std::string> names = figure.names;
  series.x = places_of(given, names);
  const PlotUnits units{{}, text_or_nothing(y_unit), at("names"), at("y")};
  if (!add_to_current(vm, std::move(series), axis, units, y_units)) return Failed{};
  figure.names = std::move(names);
  return figure_changed(vm);
}

// Fails unless all values of a figure can be shown on axes that become logarithmic.
Answer<void> check_log_of(Vm& vm, const Figure& figure) {
  for (const Figure& panel : figure.panels) {
    if (!check_log_of(vm, panel)) return Failed{};
  }
  for (const Series& series : figure.series) {
    if (!check_log(vm, figure.x, series.x, 'x', at("log")) ||
        !check_log(vm, series.right ? figure.right : figure.y, series.y, 'y', at("log"))) {
      return Failed{};
    }
  }
  return {};
}

void set_log(Figure& figure, bool x, bool y) {
  figure.x.log = x;
  figure.y.log = figure.right.log = y;
  for (Figure& panel : figure.panels) set_log(panel, x, y);
}

// Continues the figure with this title, or begins a new one.
Answer<void> figure(Vm& vm, std::string_view title, OptionalText log) {
  Host& host = Host::of(vm);
  std::vector<Figure>& figures = host.figures();
  const bool both = log == "xy" || log == "yx";
  const bool x = both || log == "x";
  const bool y = both || log == "y";
  if (log && !x && !y && !log->empty()) {
    return failure(vm, "R0626", fmt::format("there is no logarithmic axis \"{}\"", *log), at("log"),
                   "log: is \"x\", \"y\" or \"xy\"");
  }
  const auto found = std::ranges::find(figures, title, &Figure::title);
  if (found == figures.end()) {
    host.begin_figure({.title = std::string(title)});
    host.figure_changed();
  } else {
    std::rotate(found, found + 1, figures.end());
  }
  Figure& current = figures.back();
  if (!log || (current.x.log == x && current.y.log == y)) return {};
  Figure changed = current;
  set_log(changed, x, y);
  if ((x && (changed.is_spatial() || !changed.names.empty())) || changed.picture != nullptr) {
    return failure(vm, "R0626", "only an axis of numbers in the plane can be logarithmic",
                   at("log"));
  }
  if (!charge_steps(vm, changed.series.size()) || !check_log_of(vm, changed)) return Failed{};
  changed.saved = false;
  current = std::move(changed);
  return figure_changed(vm);
}

// Makes a figure of a series in space; an empty figure that was begun before is used for it.
void add_cloud(Host& host, Series series, std::string title, const std::string& unit) {
  Figure figure{.title = std::move(title), .x = {"x", unit}, .y = {"y", unit}, .z = {"z", unit}};
  figure.series.push_back(std::move(series));
  std::vector<Figure>& figures = host.figures();
  if (!figures.empty() && figures.back().is_empty()) {
    if (figure.title.empty()) figure.title = figures.back().title;
    figure.index = figures.back().index;
    figures.back() = std::move(figure);
  } else {
    host.begin_figure(std::move(figure));
  }
  host.figure_changed();
}

Failed not_spatial(Vm& vm, std::size_t values) {
  return failure(vm, "R0613", fmt::format("a point in space has 3 values, not {}", values),
                 at("points"));
}

Answer<void> scatter_lists(Vm& vm, std::span<const Slot> points, OptionalText title,
                           OptionalText unit) {
  if (!make_room(vm, 3 * points.size())) return Failed{};
  Series series{.kind = SeriesKind::kPoints};
  for (std::vector<double>* part : {&series.x, &series.y, &series.z}) part->reserve(points.size());
  for (const Slot point : points) {
    const auto p = reals_value(point);
    if (p.size() != 3) return not_spatial(vm, p.size());
    series.x.push_back(p[0]);
    series.y.push_back(p[1]);
    series.z.push_back(p[2]);
  }
  add_cloud(Host::of(vm), std::move(series), text_or_nothing(title), text_or_nothing(unit));
  return {};
}

Answer<void> scatter_matrix(Vm& vm, const MatrixObj& points, OptionalText title,
                            OptionalText unit) {
  if (points.cols != 3) return not_spatial(vm, points.cols);
  if (!make_room(vm, std::size_t{3} * points.rows)) return Failed{};
  Series series{.kind = SeriesKind::kPoints};
  for (std::size_t i = 0; i < points.rows; ++i) {
    const double* p = points.data() + 3 * i;
    series.x.push_back(p[0]);
    series.y.push_back(p[1]);
    series.z.push_back(p[2]);
  }
  add_cloud(Host::of(vm), std::move(series), text_or_nothing(title), text_or_nothing(unit));
  return {};
}

constexpr FileKind kPicture{"a picture", kPictureEndings};

std::size_t points_of(const Figure& figure) {
  std::size_t count = 0;
  for (const Figure& panel : figure.panels) count += points_of(panel);
  for (const Series& series : figure.series) count += series.x.size();
  if (figure.picture != nullptr) count += figure.picture->bytes().size();
  return count;
}

Answer<void> save_plot(Vm& vm, std::string_view file, OptionalText title) {
  Host& host = Host::of(vm);
  const std::string path(file);
  std::vector<Figure*> chosen;
  for (Figure& figure : host.figures()) {
    if (!title || figure.title == *title) chosen.push_back(&figure);
  }
  if (chosen.empty() && title) {
    return failure(vm, "R0626", fmt::format("there is no figure \"{}\"", *title), at("figure"));
  }
  if (chosen.empty()) {
    return failure(vm, "R0626", "there is no figure to save", at("path"), {},
                   "call plot(x, y) before");
  }
  const bool as_text = path.ends_with(".txt");
  if (!as_text && !path.ends_with(".svg")) {
    return failure(vm, "R0626", fmt::format("a picture is a .svg or .txt file, not \"{}\"", path),
                   at("path"));
  }
  constexpr std::uint64_t kCost = 256;  // of a point, until it is in a picture
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
                   fmt::format("\"{}\" cannot be written: {}", path, saved.error().message),
                   at("path"));
  }
  for (Figure* each : chosen) each->saved = true;
  return {};
}

constexpr CallOptions kWithAxis{.check = check_word<"axis", kAxisSides>};

constexpr NativeFunction kPlotFunctions[] = {
    def<figure>("figure(title: string, log: string?)",
                "Begins a figure, or goes on with the one of that title; what is plotted next "
                "belongs to it. "
                "log: \"y\", \"x\" or \"xy\" makes these axes logarithmic, which show values above "
                "zero only.",
                "figure(\"speeds\")", {.check = check_word<"log", kLogarithmicAxes>}),
    def<plot_values<SeriesKind::kLine>>(
        "plot(x: D[], y: E[], label: string?, axis: string?, xUnit: unit(x)?, yUnit: unit(y)?, "
        "yUnits: units(y)?)",
        "Draws a line through the points (x, y); label: its name in the legend, axis: \"left\" or "
        "\"right\", with a unit of its own. Units come from the types; those of numbers for "
        "joints, "
        "such as a column of jointSpeeds(), from the joints that the text shows, and what has "
        "another "
        "unit than the axis is drawn on the other side.",
        "plot([0s, 1s, 2s], [0deg, 30deg, 90deg], label: \"joint 1\")", kWithAxis),
    def<plot_values<SeriesKind::kPoints>>(
        "scatter(x: D[], y: E[], label: string?, axis: string?, xUnit: unit(x)?, yUnit: unit(y)?, "
        "yUnits: units(y)?)",
        "Draws points; lengths over lengths are drawn to one scale.",
        "scatter([100mm, 200mm], [0mm, 50mm])", kWithAxis),
    def<plot_values<SeriesKind::kBars>>(
        "bars(x: D[], y: E[], label: string?, axis: string?, xUnit: unit(x)?, yUnit: unit(y)?, "
        "yUnits: units(y)?)",
        "Draws a bar from zero to y at each x.", "bars([1.0, 2.0, 3.0], [4.0, 2.0, 5.0])",
        kWithAxis),
    def<named_bars>(
        "bars(names: string[], y: E[], label: string?, axis: string?, yUnit: unit(y)?, yUnits: "
        "units(y)?)",
        "Draws a bar for each name, which stands below it. Further bars of the figure stand beside "
        "those of the same name.",
        "bars([\"base\", \"shoulder\", \"elbow\"], [12Nm, 31Nm, 8Nm], label: \"no load\")",
        kWithAxis),
    def<scatter_lists>("scatter3(points: D[][], title: string?, pointsUnit: unit(points)?)",
                       "A figure of points [x, y, z] in space; the colour shows the height.",
                       "scatter3([[100mm, 0mm, 50mm], [0mm, 100mm, 80mm]], title: \"reach\")"),
    def<scatter_matrix>("scatter3(points: matrix, title: string?, unit: string?)",
                        "The same for the rows of a matrix of three columns; unit: what its "
                        "numbers are in SI, such "
                        "as \"m\".",
                        "scatter3([0.1, 0, 0.05; 0, 0.1, 0.08], title: \"reach\", unit: \"m\")"),
    def<save_plot>(
        "savePlot(path: string, figure: string?)",
        "Saves all figures, or the one of that title, below the folder of the program: a picture "
        "(.svg) "
        "or text (.txt).",
        "plot([0s, 1s], [0deg, 30deg]); savePlot(\"speeds.svg\")",
        {.check = check_ending<"path", kPictureEndings>}),
};

}  // namespace

std::span<const NativeFunction> plot_functions() { return kPlotFunctions; }

}  // namespace armlet::bind
