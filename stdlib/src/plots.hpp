#pragma once
// Figures of a program (language reference, section 16): what the functions that draw share.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "armlet/plot/figure.hpp"
#include "armlet/stdlib/host.hpp"
#include "bind.hpp"

namespace armlet::bind {

[[nodiscard]] inline std::string text_or_nothing(Slot s) {
  return s.o != nullptr ? std::string(text_value(s)) : std::string();
}

// The figure that plot adds to: the last one, or a first one without a title.
[[nodiscard]] Figure& current_figure(Host& host);

// Room for more values, as steps and as memory of the host. False: the failure is set.
[[nodiscard]] bool has_room(Vm& vm, std::size_t more);

// Adds a series to a figure or a panel whose axes show, or from now on show, these units.
//
// x_parameter, y_parameter  of the call, for messages.
// False: the failure is set and the figure shows what it did before.
struct PlotUnits {
  std::string x{}, y{};
  int x_parameter = 0, y_parameter = 0;
};
[[nodiscard]] bool add_series(Vm& vm, Figure& figure, Series series, const PlotUnits& units);

// Whether an axis that is logarithmic can show all of the values, of which the finite ones have to
// be above zero. False: the failure is set.
[[nodiscard]] bool check_log(Vm& vm, const Axis& axis, std::span<const double> values, char name,
                             int parameter);

// The panels of a figure that is empty or has panels of these titles already; null: the failure is
// set.
[[nodiscard]] std::vector<Figure>* panels_of(Vm& vm, Figure& figure,
                                             const std::vector<std::string>& titles);

// "left" or "right" from an argument that may be left out. False: the failure is set.
[[nodiscard]] bool read_side(Vm& vm, Slot s, int parameter, bool& right);

// The texts of a list argument: one for each of `count` lines, or none if it was left out. False:
// the failure is set.
[[nodiscard]] bool read_labels(Vm& vm, Slot s, int parameter, std::size_t count,
                               std::vector<std::string>& labels);

}  // namespace armlet::bind
