#pragma once
// Figures of a program (language reference, section 16): helpers shared by the functions that draw.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/plot/figure.hpp"
#include "armlet/stdlib/host.hpp"
#include "values/bind.hpp"

namespace armlet::bind {

// A text or a list argument that may be left out.
using OptionalText = std::optional<std::string_view>;
using OptionalItems = std::optional<std::span<const Slot>>;

[[nodiscard]] inline std::string text_or_nothing(OptionalText text) {
  return std::string(text.value_or(""));
}

// The figure that plot adds to: the last one, or a first one without a title.
[[nodiscard]] Figure& current_figure(Host& host);

// Reports to listeners that the last figure has changed.
[[nodiscard]] inline Answer<void> figure_changed(Vm& vm) {
  Host::of(vm).figure_changed();
  return {};
}

// Counts `more` values as steps and as memory of the host; `fix` is what else can be done.
[[nodiscard]] Answer<void> make_room(
    Vm& vm, std::size_t more, std::string_view fix = "draw fewer points, for example every tenth");

// Adds a series to a figure or panel. Its axes show these units, or show them from now
// on.
//
// x_part, y_part  of the call, for messages.
// is_read   the type of y has no unit; the check before the run has determined it from
//           the text. If the axis shows another unit, y is drawn on the other side; if it
//           shows plain numbers, as plain numbers.
// is_side_given  the program gives the side. A failure leaves the figure unchanged.
struct PlotUnits {
  std::string x{}, y{};
  CallPart x_part = CallPart::first(), y_part = CallPart::first();
  bool is_read = false;
  bool is_side_given = false;
};
[[nodiscard]] Answer<void> add_series(Vm& vm, Figure& figure, Series series,
                                      const PlotUnits& units);

// Adds one series for each unit; `each` holds a unit for every value, or nothing if the units are
// unknown.
[[nodiscard]] Answer<void> add_by_unit(Vm& vm, Figure& figure, Series series, PlotUnits units,
                                       const std::vector<std::string>& each);

// The units of `count` values as read from the text; none: unknown, or the program gives one.
[[nodiscard]] std::vector<std::string> read_units(Vm& vm, OptionalText read, OptionalText given,
                                                  std::size_t count);

// Fails unless a logarithmic axis can show all of the values: the finite ones have to be above
// zero.
[[nodiscard]] Answer<void> check_log(Vm& vm, const Axis& axis, std::span<const double> values,
                                     char name, CallPart part);

// The panels of a figure that is empty or already has panels with these titles.
[[nodiscard]] Answer<std::vector<Figure>*> panels_of(Vm& vm, Figure& figure,
                                                     const std::vector<std::string>& titles);

// Whether an optional argument is "right", not "left"; fails for other words.
[[nodiscard]] Answer<bool> is_right(Vm& vm, OptionalText side, CallPart part);

// The texts of a list argument: one for each of `count` lines, or empty ones if it was left out.
[[nodiscard]] Answer<std::vector<std::string>> labels_of(Vm& vm, OptionalItems labels,
                                                         CallPart part, std::size_t count);

}  // namespace armlet::bind
