// Several lines in one call: the columns of a matrix, the lists of a list, the joints of positions.

#include <fmt/format.h>

#include <algorithm>

#include "plot/plots.hpp"
#include "rules/rules_settings.hpp"
#include "values/setting_words.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

// The values of the parameters after x and y.
struct LineOptions {
  OptionalItems label;
  OptionalText axis;
  OptionalText x_unit;
  OptionalText y_unit;
  OptionalText y_units;  // a unit for each line, as determined by the check before the run
};

// Adds lines over one x, all or none of them. value(line, i) is the value of a line at x[i].
template <class F>
Answer<void> add_lines(Vm& vm, std::span<const double> x, std::size_t lines,
                       const LineOptions& options, F value) {
  const auto labels = labels_of(vm, options.label, at("label"), lines);
  if (!labels) return Failed{};
  const auto right = is_right(vm, options.axis, at("axis"));
  if (!right || !make_room(vm, 2 * lines * x.size())) return Failed{};
  PlotUnits units{text_or_nothing(options.x_unit), text_or_nothing(options.y_unit), at("x"),
                  at("y")};
  units.is_side_given = options.axis.has_value();
  const auto read = read_units(vm, options.y_units, options.y_unit, lines);
  Figure& figure = current_figure(Host::of(vm));
  const std::size_t had = figure.series.size();
  for (std::size_t k = 0; k < lines; ++k) {
    Series series{.label = (*labels)[k], .x = {x.begin(), x.end()}, .right = *right};
    series.y.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) series.y.push_back(value(k, i));
    units.is_read = !read.empty();
    if (units.is_read) units.y = read[k];
    if (add_series(vm, figure, std::move(series), units)) continue;
    figure.series.resize(had);
    return Failed{};
  }
  return figure_changed(vm);
}

// Plots over the indices 0, 1, 2, ...
Answer<void> plot_numbered(Vm& vm, std::span<const double> y, OptionalText label, OptionalText axis,
                           OptionalText y_unit, OptionalText y_units) {
  if (!make_room(vm, 2 * y.size())) return Failed{};
  const auto right = is_right(vm, axis, at("axis"));
  if (!right) return Failed{};
  Series series{.label = text_or_nothing(label), .y = {y.begin(), y.end()}, .right = *right};
  for (std::size_t i = 0; i < y.size(); ++i) series.x.push_back(static_cast<double>(i));
  PlotUnits units{{}, text_or_nothing(y_unit), at("y"), at("y")};
  units.is_side_given = axis.has_value();
  const auto each = read_units(vm, y_units, y_unit, y.size());
  if (!add_by_unit(vm, current_figure(Host::of(vm)), std::move(series), std::move(units), each))
    return Failed{};
  return figure_changed(vm);
}

Answer<void> plot_matrix(Vm& vm, std::span<const double> x, const MatrixObj& y, OptionalItems label,
                         OptionalText axis, OptionalText x_unit, OptionalText y_unit,
                         OptionalText y_units) {
  if (y.rows != x.size()) return size_failure(vm, "x and the rows of y", x.size(), y.rows);
  return add_lines(vm, x, y.cols, {label, axis, x_unit, y_unit, y_units},
                   [&](std::size_t k, std::size_t i) { return y.data()[i * y.cols + k]; });
}

Answer<void> plot_lists(Vm& vm, std::span<const double> x, std::span<const Slot> lists,
                        OptionalItems label, OptionalText axis, OptionalText x_unit,
                        OptionalText y_unit, OptionalText y_units) {
  for (std::size_t k = 0; k < lists.size(); ++k) {
    const std::size_t have = reals_value(lists[k]).size();
    if (have == x.size()) continue;
    const bool is_rows = lists.size() == x.size();
    return failure(vm, "R0613", fmt::format("y[{}] has {} values for {} of x", k, have, x.size()),
                   at("y"), is_rows ? "each list is a line: this one has a list for each x" : "",
                   is_rows ? "plot(x, matrix(y)) draws its columns" : "");
  }
  return add_lines(vm, x, lists.size(), {label, axis, x_unit, y_unit, y_units},
                   [&](std::size_t k, std::size_t i) { return reals_value(lists[k])[i]; });
}

constexpr NativeFunction kPlotLinesFunctions[] = {
    def<plot_numbered>(
        "plot(y: D[], label: string?, axis: string?, yUnit: unit(y)?, yUnits: units(y)?)",
        "Draws the values of a list over their numbers 0, 1, 2, ...", "plot([2mm, 3mm, 5mm])",
        {.check = check_word<"axis", kAxisSides>}),
    def<plot_matrix>(
        "plot(x: D[], y: matrix, label: string[]?, axis: string?, xUnit: unit(x)?, yUnit: "
        "unit(y)?, "
        "yUnits: units(y)?)",
        "Draws a line for each column of a matrix, whose rows belong to x; label: their names; "
        "yUnit: "
        "what the numbers are in SI, such as \"rad\". A column run.qd of a record has the units of "
        "its "
        "joints: what turns is drawn on the left and what slides on the right.",
        "plot([0s, 1s, 2s], [0, 0; 0.5, 1; 1, 4], label: [\"a\", \"b\"], yUnit: \"rad\")",
        {.check = check_word<"axis", kAxisSides>}),
    def<plot_lists>(
        "plot(x: D[], y: E[][], label: string[]?, axis: string?, xUnit: unit(x)?, yUnit: unit(y)?, "
        "yUnits: units(y)?)",
        "Draws a line for each list of a list; label: their names.",
        "plot([0s, 1s, 2s], [[0deg, 30deg, 90deg], [0deg, 60deg, 180deg]], label: [\"a\", \"b\"])",
        {.check = check_word<"axis", kAxisSides>}),
};

}  // namespace

std::span<const NativeFunction> plot_line_functions() { return kPlotLinesFunctions; }

}  // namespace armlet::bind
