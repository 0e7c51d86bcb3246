#pragma once
// Figures of a program (language reference, section 16): what the functions that draw share.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/plot/figure.hpp"
#include "armlet/stdlib/host.hpp"
#include "session/bind.hpp"

namespace armlet::bind {

// A text or a list that may be left out.
using OptionalText = std::optional<std::string_view>;
using OptionalItems = std::optional<std::span<const Slot>>;

[[nodiscard]] inline std::string text_or_nothing(OptionalText text) {
  return std::string(text.value_or(""));
}

// The figure that plot adds to: the last one, or a first one without a title.
[[nodiscard]] Figure& current_figure(Host& host);

// The last figure has changed: tells who listens.
[[nodiscard]] inline Answer<void> figure_changed(Vm& vm) {
  Host::of(vm).figure_changed();
  return {};
}

// Room for more values, as steps and as memory of the host.
[[nodiscard]] Answer<void> make_room(Vm& vm, std::size_t more);

// Adds a series to a figure or a panel whose axes show, or from now on show, these units.
//
// x_parameter, y_parameter  of the call, for messages.
// is_read   y is the unit of numbers whose type has none, as the check has read it from the text.
//           Where the axis shows another one, they are drawn on the other side; where it shows
//           plain numbers, as such.
// is_side_given  the program says on which side.
// A failure leaves the figure as it was.
struct PlotUnits {
  std::string x{}, y{};
  int x_parameter = 0, y_parameter = 0;
  bool is_read = false;
  bool is_side_given = false;
};
[[nodiscard]] Answer<void> add_series(Vm& vm, Figure& figure, Series series,
                                      const PlotUnits& units);

// The same with a series for each unit of the values, of which `each` has one for every value, or
// none if nothing is known of them.
[[nodiscard]] Answer<void> add_by_unit(Vm& vm, Figure& figure, Series series, PlotUnits units,
                                       const std::vector<std::string>& each);

// The units that were read of so many values; none: nothing is known, or the unit is given.
[[nodiscard]] std::vector<std::string> read_units(Vm& vm, OptionalText read, OptionalText given,
                                                  std::size_t count);

// Fails unless an axis that is logarithmic can show all of the values, of which the finite ones
// have to be above zero.
[[nodiscard]] Answer<void> check_log(Vm& vm, const Axis& axis, std::span<const double> values,
                                     char name, int parameter);

// The panels of a figure that is empty or has panels of these titles already.
[[nodiscard]] Answer<std::vector<Figure>*> panels_of(Vm& vm, Figure& figure,
                                                     const std::vector<std::string>& titles);

// Whether an argument that may be left out is "right" and not "left".
[[nodiscard]] Answer<bool> is_right(Vm& vm, OptionalText side, int parameter);

// The texts of a list argument: one for each of `count` lines, or empty ones if it was left out.
[[nodiscard]] Answer<std::vector<std::string>> labels_of(Vm& vm, OptionalItems labels,
                                                         int parameter, std::size_t count);

}  // namespace armlet::bind
