// The contents of a `lab` block, and the default page of a program without one.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "armlet/cell/cell.hpp"
#include "armlet/core/format.hpp"
#include "armlet/stdlib/laboratory_rows.hpp"
#include "laboratory/lab_text.hpp"

namespace armlet {

std::string_view word_of(LabRowKind kind) {
  constexpr std::array<std::string_view, 11> kWords = {"sliders", "field", "button", "plot",
                                                       "table",   "text",  "image",  "trail",
                                                       "torques", "view",  "program"};
  return kWords[static_cast<std::size_t>(kind)];
}

std::string_view word_of(HandAxis axis) {
  constexpr std::array<std::string_view, 7> kWords = {"x",     "y",   "z",   "roll",
                                                      "pitch", "yaw", "roll"};
  return kWords[static_cast<std::size_t>(axis)];
}

const LabRow* LabRows::find(std::string_view row) const {
  const auto found = std::ranges::find(rows, row, &LabRow::name);
  return found == rows.end() ? nullptr : &*found;
}

LabRows default_lab_rows(const Cell& cell) {
  LabRows page{.name = "lab", .title = "Laboratory"};
  const auto add = [&](LabRowKind kind, std::string name, const std::string& robot) -> LabRow& {
    return page.rows.emplace_back(
        LabRow{.kind = kind, .name = name, .label = std::move(name), .robot = robot});
  };
  for (int i = 0; i < cell.robot_count(); ++i) {
    const std::string& robot = cell.robot(i).name;
    add(LabRowKind::kSliders, "joints of " + robot, robot);
    std::vector<HandAxis>& axes = add(LabRowKind::kSliders, "hand of " + robot, robot).axes;
    axes = {HandAxis::kX, HandAxis::kY, HandAxis::kZ};
    if (cell.robot(i).model->n() > 3) axes.push_back(HandAxis::kTurn);
    add(LabRowKind::kPlot, "q of " + robot, robot);
    add(LabRowKind::kPlot, "qd of " + robot, robot);
  }
  return page;
}

std::string number_text(double si, const LabRow& field) {
  if (field.type == LabFieldType::kInt) return fmt::format("{}", static_cast<std::int64_t>(si));
  if (field.dim.is_none()) return format_number(si, 9);
  const auto unit = parse_unit(field.unit);
  return fmt::format("{} {}", format_number(si / (unit ? unit->factor : 1.0), 9), field.unit);
}

std::string field_text(const Value& value) {
  if (const auto* number = value.get_if<Value::Number>()) {
    const DisplayUnit unit = display_unit(number->dim, number->si);
    const std::string digits = format_number(number->si / unit.factor, 9);
    return number->dim.is_none() ? digits : digits + ' ' + unit.name;
  }
  if (const auto* whole = value.get_if<std::int64_t>()) return fmt::format("{}", *whole);
  if (const auto* truth = value.get_if<bool>()) return *truth ? "true" : "false";
  if (const auto* text = value.get_if<std::string>()) return '"' + *text + '"';
  return value.kind();
}

}  // namespace armlet
