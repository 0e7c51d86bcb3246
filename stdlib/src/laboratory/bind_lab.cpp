// Laboratories: the block `lab` and its rows (language reference, section 16).
//
// A row is checked twice: before the run as far as its text shows its values, and when the block is
// executed. The content of a row, a value or a lambda, is a variable of the program.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "armlet/stdlib/host.hpp"
#include "armlet/stdlib/laboratory_rows.hpp"
#include "laboratory/lab_rules.hpp"
#include "laboratory/lab_values.hpp"
#include "laboratory/row_results.hpp"
#include "messages/library_messages.hpp"
#include "values/bind.hpp"
#include "values/number_units.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

using Text = std::string_view;
using OptionalWord = std::optional<std::string_view>;

Answer<LabRow> sliders(Vm& vm, const RobotRef& of, OptionalWord as, OptionalWord label, Text name) {
  LabRow made = row_of(vm, LabRowKind::kSliders, name, label);
  made.robot = of.cell->robot(of.id).name;
  if (as) {
    Result<std::vector<HandAxis>> axes = hand_axes(*as);
    if (!axes) return refuse_row(vm, made.kind, axes.error().message, at("as"));
    made.axes = *std::move(axes);
  }
  return made;
}

template <class Number>
Answer<LabRow> number_field(Vm& vm, LabRow made, Number value,
                            std::optional<std::array<Number, 2>> range) {
  if (!range) return made;
  const auto [lower, upper] = *range;
  made.range = {static_cast<double>(lower), static_cast<double>(upper)};
  if (!(lower <= upper)) return refuse_row(vm, made.kind, kRangeOrder, at("range"));
  if (value < lower || value > upper)
    return refuse_row(vm, made.kind, outside_range(made.value, made), at("value"));
  return made;
}

Answer<LabRow> quantity_field(Vm& vm, double value, std::optional<std::span<const double>> range,
                              OptionalWord label, OptionalWord si_unit, Text name) {
  LabRow made = row_of(vm, LabRowKind::kField, name, label);
  if (const auto unit = parse_unit(si_unit.value_or(""))) made.dim = unit->dim;
  made.value = Value(Value::Number{value, made.dim});
  if (range && range->size() != 2) return refuse_row(vm, made.kind, kRangeSize, at("range"));
  const double shown = value != 0.0 || !range ? value : (*range)[1];
  if (!made.dim.is_none()) made.unit = display_unit(made.dim, shown).name;
  std::optional<std::array<double, 2>> limits;
  if (range) limits = {(*range)[0], (*range)[1]};
  return number_field(vm, std::move(made), value, limits);
}

Answer<LabRow> int_field(Vm& vm, std::int64_t value, std::optional<std::span<const Slot>> range,
                         OptionalWord label, Text name) {
  LabRow made = row_of(vm, LabRowKind::kField, name, label);
  made.type = LabFieldType::kInt;
  made.value = Value(value);
  if (range && range->size() != 2) return refuse_row(vm, made.kind, kRangeSize, at("range"));
  std::optional<std::array<std::int64_t, 2>> limits;
  if (range) limits = {(*range)[0].i, (*range)[1].i};
  return number_field(vm, std::move(made), value, limits);
}

LabRow bool_field(Vm& vm, bool value, OptionalWord label, Text name) {
  LabRow made = row_of(vm, LabRowKind::kField, name, label);
  made.type = LabFieldType::kBool;
  made.value = Value(value);
  return made;
}

LabRow text_field(Vm& vm, Text value, OptionalWord label, Text name) {
  LabRow made = row_of(vm, LabRowKind::kField, name, label);
  made.type = LabFieldType::kText;
  made.value = Value(value);
  return made;
}

LabRow button(Vm& vm, Text label, FunctionValue, Text name) {
  return row_of(vm, LabRowKind::kButton, name, label);
}

LabRow plot(Vm& vm, FunctionValue, OptionalWord label, OptionalWord units, Text name) {
  LabRow made = row_of(vm, LabRowKind::kPlot, name, label);
  made.is_read = true;
  made.dims = numbers_in(units.value_or(""));
  return made;
}

LabRow table(Vm& vm, FunctionValue, std::optional<std::span<const Slot>> header, OptionalWord label,
             OptionalWord units, Text name) {
  LabRow made = row_of(vm, LabRowKind::kTable, name, label);
  made.is_read = true;
  made.dims = numbers_in(units.value_or(""));
  for (const Slot& each : header.value_or(std::span<const Slot>()))
    made.header.emplace_back(text_value(each));
  return made;
}

LabRow fixed_text(Vm& vm, Text value, Text name) {
  LabRow made = row_of(vm, LabRowKind::kText, name, {});
  made.value = Value(value);
  return made;
}

LabRow changing_text(Vm& vm, FunctionValue, Text name) {
  LabRow made = row_of(vm, LabRowKind::kText, name, {});
  made.is_read = true;
  return made;
}

LabRow trail(Vm& vm, const RobotRef& of, OptionalWord label, Text name) {
  LabRow made = row_of(vm, LabRowKind::kTrail, name, label);
  made.robot = of.cell->robot(of.id).name;
  return made;
}

LabRow torques(Vm& vm, const RobotRef& of, OptionalWord label, Text name) {
  LabRow made = row_of(vm, LabRowKind::kTorques, name, label);
  made.robot = of.cell->robot(of.id).name;
  return made;
}

LabRow program(Vm& vm, OptionalWord label, Text name) {
  return row_of(vm, LabRowKind::kProgram, name, label);
}

Answer<LabRef> lab(Vm& vm, Text name, OptionalWord title, OptionalWord layout,
                   HostList<LabRow> rows) {
  LabRows page{.name = std::string(name), .title = std::string(title.value_or(name))};
  if (layout) {
    const std::optional<LabLayout> known = layout_named(*layout);
    if (!known) return failure(vm, "R0626", unknown_layout(*layout), at("layout"), {}, kLayouts);
    page.layout = *known;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) page.rows.push_back(rows[i]);
  Host::of(vm).set_lab(std::move(page));
  return LabRef{};
}

constexpr NativeFunction kLabFunctions[] = {
    def<lab>(
        "lab{}(name: string, title: string?, layout: string?, rows: labRow[]) -> lab",
        "The page on which people work with the cell (`armlet lab`); its rows are the elements "
        "of the page, in their order. layout: \"columns\" or \"stack\". A program has one such "
        "block.",
        "lab cell { title: \"Hello\"; text intro(\"Move the *arm*.\") }", {.check = check_lab}),
    def<sliders>(
        "lab.sliders.NAME(of: robot, as: string?, label: string?, name: string) -> labRow",
        "A slider for each joint of a robot, inside its limits; with as: for the coordinates of "
        "its "
        "hand, by inverse kinematics: some of x, y, z, roll, pitch and yaw. roll alone turns about "
        "z, with the tilt of the hand as it is.",
        "sliders hand(of: arm, as: \"x y z roll\")", {.check = check_sliders}),
    def<quantity_field>(
        "lab.field.NAME(value: D, range: D[]?, label: string?, valueUnit: unit(value)?, name: "
        "string) "
        "-> labRow",
        "A number that people set at the page, read as lab.NAME with its unit; range: the smallest "
        "and the largest one.",
        "field clearance(80mm, range: [20mm, 200mm])", {.check = check_field}),
    def<int_field>("lab.field.NAME(value: int, range: int[]?, label: string?, name: string) -> "
                   "labRow",
                   "A whole number, a truth value or a text that people set, read as lab.NAME.",
                   "field pieces(3, range: [1, 9])", {.check = check_field}),
    def<bool_field>("lab.field.NAME(value: bool, label: string?, name: string) -> labRow",
                    "A whole number, a truth value or a text that people set, read as lab.NAME.",
                    "field slowly(true)"),
    def<text_field>("lab.field.NAME(value: string, label: string?, name: string) -> labRow",
                    "A whole number, a truth value or a text that people set, read as lab.NAME.",
                    "field greeting(\"hello\")"),
    def<button>("lab.button.NAME(label: string, value: fn() -> void, name: string) -> labRow",
                "A button; pressing it starts the function as a task of its own, which may move.",
                "button away(\"Away\", fn() { arm.moveJ(home()) })", {.starts = true}),
    def<plot>("lab.plot.NAME(value: fn() -> T, label: string?, valueUnits: units(value)?, name: "
              "string) -> "
              "labRow",
              "What the function gives over time: a number, numbers in a list, joint values.",
              "plot angles(fn() => arm.joints())", {.check = check_plot}),
    def<table>("lab.table.NAME(value: fn() -> T, header: string[]?, label: string?, valueUnits: "
               "units(value)?, name: string) -> labRow",
               "What the function gives now, as a table: a matrix, a list of rows, a table.",
               "table dh(fn() => arm.dhTable(), header: [\"theta\", \"d\", \"a\", \"alpha\"])",
               {.check = check_table}),
    def<fixed_text, changing_text>(
        "lab.text.NAME(value: string | fn() -> string, name: string) -> labRow",
        "A text in Markdown, with formulas between $ signs; a function gives one that "
        "changes.",
        "text intro(\"The arm has **four** joints: $q_1 \\\\dots q_4$.\"); text where(fn() => "
        "f\"The hand is at {arm.here()}.\")"),
    def<trail>("lab.trail.NAME(of: robot, label: string?, name: string) -> labRow",
               "The path of the hand of a robot, in the view of the cell.", "trail way(of: arm)"),
    def<torques>("lab.torques.NAME(of: robot, label: string?, name: string) -> labRow",
                 "A bar at each joint of a robot in the view of the cell: what its motor gives, as "
                 "a share of the maxTorque or maxForce of the joint.",
                 "torques bars(of: arm)"),
    def<program>("lab.program.NAME(label: string?, name: string) -> labRow",
                 "A place to write, check and run programs.", "program editor()"),
};

}  // namespace

std::span<const NativeFunction> lab_functions() { return kLabFunctions; }

}  // namespace armlet::bind
