#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "armlet/core/format.hpp"
#include "armlet/kinematics/limits.hpp"
#include "armlet/stdlib/laboratory_controls.hpp"
#include "controls/hand.hpp"
#include "laboratory/lab_rules.hpp"
#include "laboratory/lab_text.hpp"
#include "session/run.hpp"
#include "values/number_units.hpp"
#include "values/values.hpp"

namespace armlet {
namespace {

Error no_lab() { return {"no lab", "The program has not come to a `lab` block."}; }

// The names of the rows of one kind: "`a`, `b`".
std::string names_of(const std::vector<LabRow>& rows, LabRowKind kind) {
  std::string names;
  for (const LabRow& row : rows)
    if (row.kind == kind) names += fmt::format("{}`{}`", names.empty() ? "" : ", ", row.name);
  return names;
}

Result<const LabRow*> find_row(const LabRows& page, LabRowKind kind, std::string_view name) {
  if (const LabRow* row = page.find(name); row != nullptr && row->kind == kind) return row;
  const std::string known = names_of(page.rows, kind);
  return Error{"unknown", fmt::format("`{}` has no {} `{}`; it has {}.", page.name, word_of(kind),
                                      name, known.empty() ? "none at all" : known)};
}

Result<int> find_robot(const Cell& cell, std::string_view name) {
  if (const auto robot = cell.find_robot(name)) return *robot;
  std::string known;
  for (int i = 0; i < cell.robot_count(); ++i)
    known += fmt::format("{}`{}`", known.empty() ? "" : ", ", cell.robot(i).name);
  return Error{"unknown", fmt::format("There is no robot `{}`; the cell has {}.", name,
                                      known.empty() ? "none" : known)};
}

// The number in a value for this field; an int is accepted for a plain number.
std::optional<double> number_in(const Value& value, const LabRow& field) {
  if (const auto* whole = value.get_if<std::int64_t>())
    return field.dim.is_none() ? std::optional(static_cast<double>(*whole)) : std::nullopt;
  const auto* number = value.get_if<Value::Number>();
  if (number == nullptr || number->dim != field.dim) return std::nullopt;
  return number->si;
}

Error wrong_type(const LabRow& field, const Value& value) {
  const std::string wanted = field.type == LabFieldType::kBool   ? "true or false"
                             : field.type == LabFieldType::kText ? "a text"
                             : field.type == LabFieldType::kInt  ? "a whole number"
                                                                 : dimension_phrase(field.dim);
  return {"type",
          fmt::format("The field `{}` takes {}, not {}.", field.name, wanted, field_text(value))};
}

// The value, converted to the type of the field's variable.
Result<Value> fitting(const LabRow& field, const Value& value) {
  if (field.type == LabFieldType::kBool || field.type == LabFieldType::kText) {
    const bool fits = value.content().index() == field.value.content().index();
    return fits ? Result<Value>(value) : wrong_type(field, value);
  }
  const auto number = number_in(value, field);
  const bool is_int = field.type == LabFieldType::kInt;
  if (!number || (is_int && (*number != std::floor(*number) || std::abs(*number) > 0x1p53)))
    return wrong_type(field, value);
  if (!std::isfinite(*number))
    return Error{"type", fmt::format("The field `{}` takes a finite number.", field.name)};
  if (field.range && (*number < (*field.range)[0] || *number > (*field.range)[1])) {
    return Error{"range",
                 fmt::format("The field `{}` goes from {} to {}; {} lies outside.", field.name,
                             number_text((*field.range)[0], field),
                             number_text((*field.range)[1], field), number_text(*number, field))};
  }
  if (is_int) return Value(static_cast<std::int64_t>(*number));
  return Value(Value::Number{*number, field.dim});
}

// Joint values and poses as lists of numbers with their units.
Value shown(Value value) {
  if (const auto* list = value.get_if<Value::List>()) {
    Value::List out;
    for (const Value& each : *list) out.push_back(shown(each));
    return out;
  }
  const auto* host = value.get_if<Value::Host>();
  if (host == nullptr || host->type != &bind::kPosJ) return value;
  const auto& q = *static_cast<const bind::PosJ*>(host->value.get());
  Value::List out;
  for (std::size_t i = 0; i < q.n; ++i) {
    const Dim dim = !q.kinds_known ? dims::kNone : q.turns[i] ? dims::kAngle : dims::kLength;
    out.push_back(Value::Number{q.q[i], dim});
  }
  return out;
}

// Gives units to the numbers of a value that have none, one dimension for each number; a matrix
// becomes a list of its rows. False: the number of dimensions is not that of the numbers.
bool give_units(Value& value, std::span<const Dim>& dims) {
  if (const auto* list = value.get_if<Value::List>()) {
    Value::List out = *list;
    for (Value& each : out)
      if (!give_units(each, dims)) return false;
    value = std::move(out);
    return true;
  }
  if (const auto* record = value.get_if<Value::Record>()) {
    Value::Record out = *record;
    for (auto& [name, field] : out.fields)
      if (!give_units(field, dims)) return false;
    value = std::move(out);
    return true;
  }
  if (const auto* matrix = value.get_if<Value::Matrix>()) {
    if (dims.size() < matrix->elements.size()) return false;
    Value::List rows(matrix->rows);
    for (std::size_t i = 0; i < matrix->elements.size(); ++i) {
      Value& row = rows[i / matrix->cols];
      Value::List numbers = row.get_if<Value::List>() ? *row.get_if<Value::List>() : Value::List();
      numbers.push_back(Value::Number{matrix->elements[i], dims[i]});
      row = std::move(numbers);
    }
    dims = dims.subspan(matrix->elements.size());
    value = std::move(rows);
    return true;
  }
  if (dims.empty()) return false;
  const auto* number = value.get_if<Value::Number>();
  if (number != nullptr && number->dim.is_none()) value = Value::Number{number->si, dims.front()};
  dims = dims.subspan(1);
  return true;
}

Value with_units(const Value& value, std::span<const LabNumber> numbers, const Cell& cell) {
  const std::vector<Dim> known = bind::dims_of(numbers, cell);
  std::span<const Dim> dims = known;
  Value out = value;
  return give_units(out, dims) && dims.empty() ? out : value;
}

}  // namespace

const LabRows* LabControls::rows() const {
  return session_.run_->host == nullptr ? nullptr : session_.run_->host->lab();
}

// ---- fields and buttons ---------------------------------------------------------------------

std::optional<Error> LabControls::refusal() const {
  session_.require_idle("take an input");
  if (session_.run_->is_under_way) return std::nullopt;
  return Error{"ended", session_.run_->vm == nullptr
                            ? "The program has not begun."
                            : "The run has ended; go back to a time before its end."};
}

std::optional<Error> LabControls::apply(const Action& action) {
  try {
    if (auto refused = session_.act(action)) return refused;
  } catch (const ArgumentError& error) {
    return Error{"failed", error.what()};
  }
  session_.keep({.at = {}, .what = action});
  return std::nullopt;
}

std::optional<Error> LabControls::set_field(std::string_view name, const Value& value) {
  if (auto refused = refusal()) return refused;
  if (rows() == nullptr) return no_lab();
  const Result<const LabRow*> row = find_row(*rows(), LabRowKind::kField, name);
  if (!row) return row.error();
  const Result<Value> fit = fitting(**row, value);
  if (!fit) return fit.error();
  return apply(SetGlobal{fmt::format("{}.{}", rows()->name, name), *fit});
}

Result<Value> LabControls::field(std::string_view name) const {
  if (rows() == nullptr) return no_lab();
  const Result<const LabRow*> row = find_row(*rows(), LabRowKind::kField, name);
  if (!row) return row.error();
  return session_.run_->vm->try_global(fmt::format("{}.{}", rows()->name, name));
}

std::optional<Error> LabControls::press(std::string_view name) {
  if (auto refused = refusal()) return refused;
  if (rows() == nullptr) return no_lab();
  const Result<const LabRow*> row = find_row(*rows(), LabRowKind::kButton, name);
  if (!row) return row.error();
  return apply(PressButton{fmt::format("{}.{}", rows()->name, name)});
}

Result<Value> LabControls::read(std::string_view name) {
  session_.require_idle("read a row");
  if (rows() == nullptr) return no_lab();
  const LabRow* row = rows()->find(name);
  if (row == nullptr || !row->is_read || row->kind == LabRowKind::kImage) {
    return Error{"unknown",
                 fmt::format("`{}` has no plot, table or changing text `{}`.", rows()->name, name)};
  }
  if (row->kind == LabRowKind::kView) {
    try {
      return features(*row, row->takes_picture ? seen(*row) : Image());
    } catch (const ArgumentError& error) {
      return Error{"failed", error.what()};
    }
  }
  Result<Value> value = call(*row);
  if (!value) return value;
  return with_units(shown(*std::move(value)), row->dims, session_.run_->host->cell());
}

// ---- robots ---------------------------------------------------------------------------------

std::optional<Error> LabControls::move_joints(std::string_view name, const Eigen::VectorXd& q) {
  if (auto refused = refusal()) return refused;
  const Cell& cell = session_.run_->host->cell();
  const Result<int> index = find_robot(cell, name);
  if (!index) return index.error();
  const CellRobot& robot = cell.robot(*index);
  const int n = robot.model->n();
  if (q.size() != n)
    return Error{"type",
                 fmt::format("`{}` has {} joints; {} values were given.", name, n, q.size())};
  if (!q.allFinite()) return Error{"type", "Joint values are finite numbers."};
  if (cell.is_moving(*index))
    return Error{"busy", fmt::format("`{}` is moving; its sliders follow until it stands.", name)};
  if (const auto outside = limit_violations(*robot.model, q); !outside.empty())
    return Error{"range", fmt::format("`{}`: {}.", name, describe(*robot.model, outside.front()))};
  return apply(MoveJoints{std::string(name), {q.begin(), q.end()}});
}

Result<LabControls::Hand> LabControls::find_hand(std::string_view sliders) const {
  if (session_.run_->host == nullptr) return no_lab();
  const Cell& cell = session_.run_->host->cell();
  const LabRows page = rows() != nullptr ? *rows() : default_lab_rows(cell);
  const Result<const LabRow*> row = find_row(page, LabRowKind::kSliders, sliders);
  if (!row) return row.error();
  if ((*row)->axes.empty())
    return Error{"unknown", fmt::format("`{}` are sliders of joints, not of a hand.", sliders)};
  const Result<int> robot = find_robot(cell, (*row)->robot);
  if (!robot) return robot.error();
  return Hand{&cell.robot(*robot), (*row)->axes};
}

Result<Eigen::VectorXd> LabControls::joints_for_hand(std::string_view sliders,
                                                     const std::vector<double>& values) const {
  const Result<Hand> hand = find_hand(sliders);
  if (!hand) return hand.error();
  if (values.size() != hand->axes.size()) {
    return Error{"type", fmt::format("`{}` has {} sliders; {} values were given.", sliders,
                                     hand->axes.size(), values.size())};
  }
  for (const double value : values)
    if (!std::isfinite(value)) return Error{"type", "Coordinates are finite numbers."};
  Host& host = *session_.run_->host;
  UnreachedGoal goal{.t_ns = host.now_ns(),
                     .robot = host.cell().find_robot(hand->robot->name).value_or(-1)};
  Result<Eigen::VectorXd> q = hand_joints(*hand->robot, hand->axes, values, &goal);
  if (!q.ok() && q.error().code == "unreachable") host.note_unreached(std::move(goal));
  return q;
}

std::optional<Error> LabControls::move_hand(std::string_view sliders,
                                            const std::vector<double>& values) {
  if (auto refused = refusal()) return refused;
  const Result<Eigen::VectorXd> q = joints_for_hand(sliders, values);
  if (!q) return q.error();
  return move_joints(find_hand(sliders)->robot->name, *q);
}

Result<std::vector<double>> LabControls::hand(std::string_view sliders) const {
  const Result<Hand> found = find_hand(sliders);
  if (!found) return found.error();
  return hand_now(*found->robot, found->axes);
}

Result<std::vector<std::array<double, 2>>> LabControls::hand_ranges(
    std::string_view sliders) const {
  const Result<Hand> found = find_hand(sliders);
  if (!found) return found.error();
  return hand_reach(*found->robot, found->axes);
}

}  // namespace armlet
