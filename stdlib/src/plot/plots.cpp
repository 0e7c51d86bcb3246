#include "plot/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/interpreter/work.hpp"
#include "values/number_units.hpp"
#include "values/setting_words.hpp"

namespace armlet::bind {
namespace {

constexpr std::size_t kMaxValues = 5'000'000;  // of all figures of a program

std::size_t values_of(const Figure& figure) {
  std::size_t count = 0;
  for (const Figure& panel : figure.panels) count += values_of(panel);
  for (const Series& series : figure.series)
    count += series.x.size() + series.y.size() + series.z.size();
  if (figure.picture != nullptr) count += figure.picture->bytes().size() / sizeof(double);
  return count;
}

std::string unit_phrase(const std::string& unit) { return unit.empty() ? "plain numbers" : unit; }

// Fails unless an axis shows this unit or has no values yet.
Answer<void> check_unit(Vm& vm, const Axis& axis, bool is_new, const std::string& unit,
                        CallPart part) {
  if (is_new || axis.unit == unit) return {};
  return failure(vm, "R0626",
                 fmt::format("this figure shows {} on that axis, these values are {}",
                             unit_phrase(axis.unit), unit_phrase(unit)),
                 part, {}, "begin another figure(\"...\") before");
}

// The name of the quantity with this unit, if the program gives no label.
std::string quantity_name(const std::string& unit) {
  if (unit == "s") return "time";
  if (unit == "rad") return "angle";
  return {};
}

Axis& side_of(Figure& figure, bool right) { return right ? figure.right : figure.y; }

bool is_free(const Figure& figure, bool right) {
  return std::ranges::none_of(figure.series, [&](const Series& s) { return s.right == right; });
}

// Whether numbers whose unit was determined from the text can be drawn on this side: beside numbers
// of that unit, or beside plain numbers.
bool takes(Figure& figure, bool right, const std::string& unit) {
  const Axis& axis = side_of(figure, right);
  if (is_free(figure, right) || axis.unit == unit) return true;
  return axis.unit.empty() && (axis.read.empty() || axis.read == unit);
}

}  // namespace

Figure& current_figure(Host& host) {
  if (host.figures().empty()) host.begin_figure({});
  host.figures().back().saved = false;
  return host.figures().back();
}

Answer<void> make_room(Vm& vm, std::size_t more, std::string_view fix) {
  if (!charge_steps(vm, more)) return Failed{};
  std::size_t values = more;
  for (const Figure& figure : Host::of(vm).figures()) values += values_of(figure);
  if (values <= kMaxValues) return {};
  return failure(vm, "R0626",
                 fmt::format("the figures of a program hold at most {} values", kMaxValues),
                 CallPart::first(), {}, std::string(fix));
}

Answer<void> check_log(Vm& vm, const Axis& axis, std::span<const double> values, char name,
                       CallPart part) {
  if (!axis.log) return {};
  const auto low = std::ranges::find_if(values, [](double v) { return v <= 0.0; });
  if (low == values.end()) return {};
  return failure(vm, "R0609",
                 fmt::format("a logarithmic axis shows values above zero: {}[{}] is {}{}", name,
                             low - values.begin(), *low, axis.unit.empty() ? "" : " " + axis.unit),
                 part, {}, "plot magnitudes, abs(...), or begin a figure without log:");
}

Answer<void> add_series(Vm& vm, Figure& figure, Series series, const PlotUnits& units) {
  if (figure.is_spatial() || !figure.panels.empty() || figure.picture != nullptr) {
    return failure(vm, "R0626",
                   figure.is_spatial()         ? "this figure is drawn in space"
                   : figure.picture != nullptr ? "this figure shows a picture"
                                               : "this figure is drawn in panels",
                   units.x_part, {}, "begin another figure(\"...\") before");
  }
  const bool is_read = units.is_read && !units.y.empty();
  if (is_read && !units.is_side_given && !takes(figure, series.right, units.y) &&
      takes(figure, !series.right, units.y)) {
    series.right = !series.right;
  }
  Axis& upright = side_of(figure, series.right);
  const bool is_new = figure.series.empty();
  const bool new_side = is_free(figure, series.right);
  const bool fits = is_read && takes(figure, series.right, units.y);
  const bool hides_unit = !new_side && units.y.empty() && !upright.read.empty();
  if (!check_unit(vm, figure.x, is_new, units.x, units.x_part) ||
      (!fits && !hides_unit && !check_unit(vm, upright, new_side, units.y, units.y_part)) ||
      !check_log(vm, {.unit = units.x, .log = figure.x.log}, series.x, 'x', units.x_part) ||
      !check_log(vm, {.unit = units.y, .log = upright.log}, series.y, 'y', units.y_part)) {
    return Failed{};
  }
  const bool is_map = series.kind != SeriesKind::kBars && units.x == "m" && units.y == "m";
  if (is_new) figure.x = {is_map ? "x" : quantity_name(units.x), units.x, figure.x.log};
  if (new_side) {
    upright = {is_map ? "y" : quantity_name(units.y), units.y, upright.log, is_read ? units.y : ""};
  } else if (hides_unit) {
    upright.unit.clear();
    upright.label.clear();
  } else if (fits && upright.unit.empty()) {
    upright.read = units.y;
  }
  figure.series.push_back(std::move(series));
  return {};
}

Answer<void> add_by_unit(Vm& vm, Figure& figure, Series series, PlotUnits units,
                         const std::vector<std::string>& each) {
  if (each.empty()) return add_series(vm, figure, std::move(series), units);
  units.is_read = true;
  std::vector<std::string> kinds;
  for (const std::string& unit : each) {
    if (std::ranges::find(kinds, unit) == kinds.end()) kinds.push_back(unit);
  }
  const std::size_t had = figure.series.size();
  for (const std::string& unit : kinds) {
    Series part{.kind = series.kind, .label = series.label, .right = series.right};
    for (std::size_t i = 0; i < each.size(); ++i) {
      if (each[i] != unit) continue;
      part.x.push_back(series.x[i]);
      part.y.push_back(series.y[i]);
    }
    units.y = unit;
    if (add_series(vm, figure, std::move(part), units)) continue;
    figure.series.resize(had);
    return Failed{};
  }
  return {};
}

std::vector<std::string> read_units(Vm& vm, OptionalText read, OptionalText given,
                                    std::size_t count) {
  if (!read || read->empty() || (given && !given->empty())) return {};
  return units_of(*read, count, Host::of(vm).cell());
}

Answer<std::vector<Figure>*> panels_of(Vm& vm, Figure& figure,
                                       const std::vector<std::string>& titles) {
  if (figure.is_empty()) {
    for (const std::string& title : titles) {
      figure.panels.push_back(
          {.title = title, .x = figure.x, .y = figure.y, .right = figure.right});
    }
  }
  if (std::ranges::equal(figure.panels, titles, {}, &Figure::title)) return &figure.panels;
  return failure(vm, "R0626", "this figure shows something else", CallPart::first(), {},
                 "begin another figure(\"...\") before");
}

Answer<bool> is_right(Vm& vm, OptionalText side, CallPart part) {
  if (!side || *side == kAxisSides[0]) return false;
  if (*side == kAxisSides[1]) return true;
  return failure(vm, "R0626", fmt::format("there is no axis \"{}\"", *side), part,
                 "the axes are \"left\" and \"right\"");
}

Answer<std::vector<std::string>> labels_of(Vm& vm, OptionalItems labels, CallPart part,
                                           std::size_t count) {
  if (!labels) return std::vector<std::string>(count);
  if (labels->size() != count) {
    return failure(vm, "R0613",
                   fmt::format("{} label{} for {} line{}", labels->size(),
                               labels->size() == 1 ? "" : "s", count, count == 1 ? "" : "s"),
                   part);
  }
  if (!charge_work(vm, 16 * count)) return Failed{};
  std::vector<std::string> texts;
  for (const Slot label : *labels) texts.emplace_back(text_value(label));
  return texts;
}

}  // namespace armlet::bind
