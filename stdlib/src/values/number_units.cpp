#include "values/number_units.hpp"

#include <algorithm>
#include <charconv>

#include "armlet/interpreter/unit.hpp"

namespace armlet::bind {
namespace {

Dim dim_in(std::string_view unit) {
  const auto known = parse_unit(unit);
  return known ? known->dim : Dim{};
}

// "rad/s", or "@rad/s|m/s|arm#2": of joint 2 of the arm (bind::dims_by_joint).
LabNumber number_in(std::string_view text) {
  if (!text.starts_with('@')) return {.dim = dim_in(text)};
  text.remove_prefix(1);
  LabNumber number;
  const std::size_t slides = std::min(text.find('|'), text.size());
  const std::size_t name = std::min(text.find('|', slides + 1), text.size());
  const std::size_t joint = std::min(text.rfind('#'), text.size());
  if (name == text.size()) return number;
  number.dim = dim_in(text.substr(0, slides));
  number.sliding = dim_in(text.substr(slides + 1, name - slides - 1));
  const char* const end = text.data() + text.size();
  const bool is_one = joint > name && joint < text.size() &&
                      std::from_chars(text.data() + joint + 1, end, number.joint).ptr == end;
  if (!is_one) number.joint = -1;
  number.robot = text.substr(name + 1, (is_one ? joint : text.size()) - name - 1);
  return number;
}

// The robot with this name; null: there is none, or there are several.
const Robot* robot_named(const Cell& cell, const std::string& name) {
  const Robot* found = nullptr;
  for (int i = 0; i < cell.robot_count(); ++i) {
    if (cell.robot(i).name != name) continue;
    if (found != nullptr) return nullptr;
    found = cell.robot(i).model.get();
  }
  return found;
}

}  // namespace

std::vector<LabNumber> numbers_in(std::string_view units) {
  std::vector<LabNumber> numbers;
  for (std::size_t at = 0; at <= units.size() && !units.empty();) {
    const std::size_t end = std::min(units.find(',', at), units.size());
    numbers.push_back(number_in(units.substr(at, end - at)));
    at = end + 1;
  }
  return numbers;
}

std::vector<Dim> dims_of(std::span<const LabNumber> numbers, const Cell& cell) {
  std::vector<Dim> dims;
  for (const LabNumber& each : numbers) {
    if (each.robot.empty()) {
      dims.push_back(each.dim);
      continue;
    }
    const Robot* robot = robot_named(cell, each.robot);
    if (robot == nullptr || each.joint >= robot->n()) return {};
    const int first = std::max(each.joint, 0);
    const int end = each.joint < 0 ? robot->n() : each.joint + 1;
    for (int i = first; i < end; ++i)
      dims.push_back(robot->is_revolute(i) ? each.dim : each.sliding);
  }
  return dims;
}

std::string_view part_of(std::string_view units, std::size_t k) {
  for (; k > 0; --k) {
    const std::size_t end = units.find(';');
    if (end == std::string_view::npos) return {};
    units.remove_prefix(end + 1);
  }
  return units.substr(0, units.find(';'));
}

std::vector<std::string> units_of(std::string_view units, std::size_t count, const Cell& cell) {
  std::vector<std::string> names;
  for (const Dim dim : dims_of(numbers_in(units), cell)) names.push_back(si_unit(dim));
  if (names.size() == 1) names.resize(count, names.front());
  if (names.size() != count) names.clear();
  return names;
}

}  // namespace armlet::bind
