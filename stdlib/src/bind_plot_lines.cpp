// Several lines in one call: the columns of a matrix, the lists of a list, the joints of positions.

#include <fmt/format.h>

#include <algorithm>

#include "plots.hpp"
#include "values.hpp"

namespace armlet::bind {
namespace {

enum { kX, kY, kLabel, kAxis, kXUnit, kYUnit };

// Adds lines over one x, all or none of them. value(line, i) is the value of a line at x[i].
template <class F>
Signal add_lines(Vm& vm, Slot* args, std::size_t lines, F value) {
  const auto x = reals_value(args[kX]);
  std::vector<std::string> labels;
  bool right = false;
  if (!read_labels(vm, args[kLabel], kLabel, lines, labels) ||
      !read_side(vm, args[kAxis], kAxis, right) || !has_room(vm, 2 * lines * x.size())) {
    return Signal::kFail;
  }
  const PlotUnits units{text_or_nothing(args[kXUnit]), text_or_nothing(args[kYUnit]), kX, kY};
  Figure& figure = current_figure(Host::of(vm));
  const std::size_t had = figure.series.size();
  for (std::size_t k = 0; k < lines; ++k) {
    Series series{.label = labels[k], .x = {x.begin(), x.end()}, .right = right};
    series.y.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) series.y.push_back(value(k, i));
    if (add_series(vm, figure, std::move(series), units)) continue;
    figure.series.resize(had);
    return Signal::kFail;
  }
  return give_nothing();
}

// (y, label, axis, yUnit): over 0, 1, 2, ...
Signal plot_numbered(Vm& vm, Slot* args) {
  const auto y = reals_value(args[0]);
  if (!has_room(vm, 2 * y.size())) return Signal::kFail;
  Series series{.label = text_or_nothing(args[1]), .y = {y.begin(), y.end()}};
  for (std::size_t i = 0; i < y.size(); ++i) series.x.push_back(static_cast<double>(i));
  const PlotUnits units{{}, text_or_nothing(args[3]), 0, 0};
  if (!read_side(vm, args[2], 2, series.right) ||
      !add_series(vm, current_figure(Host::of(vm)), std::move(series), units)) {
    return Signal::kFail;
  }
  return give_nothing();
}

// (x, y: matrix, label, axis, xUnit, yUnit)
Signal plot_matrix(Vm& vm, Slot* args) {
  const MatrixObj& y = matrix_value(args[kY]);
  const std::size_t count = reals_value(args[kX]).size();
  if (y.rows != count) return size_failure(vm, "x and the rows of y", count, y.rows);
  return add_lines(vm, args, y.cols,
                   [&](std::size_t k, std::size_t i) { return y.data()[i * y.cols + k]; });
}

// (x, y: E[][], label, axis, xUnit, yUnit)
Signal plot_lists(Vm& vm, Slot* args) {
  const auto lists = items_value(args[kY]);
  const std::size_t count = reals_value(args[kX]).size();
  for (std::size_t k = 0; k < lists.size(); ++k) {
    const std::size_t have = reals_value(lists[k]).size();
    if (have == count) continue;
    const bool is_rows = lists.size() == count;
    return failure(vm, "R0613", fmt::format("y[{}] has {} values for {} of x", k, have, count), kY,
                   is_rows ? "each list is a line: this one has a list for each x" : "",
                   is_rows ? "plot(x, matrix(y)) draws its columns" : "");
  }
  return add_lines(vm, args, lists.size(),
                   [&](std::size_t k, std::size_t i) { return reals_value(lists[k])[i]; });
}

constexpr NativeFunction kPlotLinesFunctions[] = {
    {"plot", "(y: D[], label: string?, axis: string?, yUnit: string?)",
     "Draws the values of a list over their numbers 0, 1, 2, ...", "plot([2mm, 3mm, 5mm])",
     plot_numbered},
    {"plot", "(x: D[], y: matrix, label: string[]?, axis: string?, xUnit: string?, yUnit: string?)",
     "Draws a line for each column of a matrix, whose rows belong to x; label: their names; yUnit: "
     "what the numbers are in SI, such as \"rad\".",
     "plot([0s, 1s, 2s], [0, 0; 0.5, 1; 1, 4], label: [\"a\", \"b\"], yUnit: \"rad\")",
     plot_matrix},
    {"plot", "(x: D[], y: E[][], label: string[]?, axis: string?, xUnit: string?, yUnit: string?)",
     "Draws a line for each list of a list; label: their names.",
     "plot([0s, 1s, 2s], [[0deg, 30deg, 90deg], [0deg, 60deg, 180deg]], label: [\"a\", \"b\"])",
     plot_lists},
};

}  // namespace

std::span<const NativeFunction> plot_line_functions() { return kPlotLinesFunctions; }

}  // namespace armlet::bind
