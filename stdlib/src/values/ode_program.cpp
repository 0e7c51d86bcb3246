#include "values/ode_program.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "values/setting_words.hpp"

namespace armlet::bind {
namespace {

enum EventField { kFunction, kDirection, kStop };
enum CrossingField { kTime, kEvent, kState };
enum SolutionField { kTimes, kStates, kEvents };

}  // namespace

Obj* StateArgument::fill(std::span<const double> y) {
  if (state_ == nullptr || state_->refs != 1) {  // the program may have stored the last one
    release(vm_, state_);
    state_ = type_ != nullptr
                 ? static_cast<Obj*>(new_record(vm_, type_))
                 : static_cast<Obj*>(new_list(vm_, static_cast<std::uint32_t>(y.size()), false));
    if (state_ == nullptr) return nullptr;
  }
  Slot* const values = type_ != nullptr ? static_cast<RecordObj*>(state_)->fields()
                                        : static_cast<ListObj*>(state_)->data;
  const auto copy = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) values[i].d = y[i];
  };
  // Includes the sums of states that the method computes.
  return in_blocks(vm_, y.size(), 4 * kCost, copy) ? state_ : nullptr;
}

Answer<void> RateOfProgram::operator()(double t, std::span<const double> y,
                                       std::span<double> rate) {
  Obj* const state = y_.fill(y);
  if (state == nullptr) return Failed{};
  const Slot arguments[] = {slot_of(t), slot_of(state)};
  Slot result;
  if (!vm_.call(f_, arguments, result)) return Failed{};
  const auto values = reals_value(result);
  const std::size_t count = values.size();
  if (count == rate.size()) std::ranges::copy(values, rate.begin());
  release(vm_, result.o);
  if (count == rate.size()) return {};
  return failure(vm_, "R0613",
                 fmt::format("the function given to ode returns {} values for a state of {}", count,
                             rate.size()),
                 part_, "it gives the rate of change of every element of the state");
}

Answer<void> RateOfStructs::operator()(double t, std::span<const double> y,
                                       std::span<double> rate) {
  Obj* const state = y_.fill(y);
  if (state == nullptr) return Failed{};
  const Slot arguments[] = {slot_of(t), slot_of(state)};
  Slot result;
  if (!vm_.call(f_, arguments, result)) return Failed{};
  const auto* rates = static_cast<const RecordObj*>(result.o);
  for (std::size_t i = 0; i < rate.size(); ++i) rate[i] = rates->fields()[i].d;
  release(vm_, result.o);
  return {};
}

void check_rates(CheckCall& call) {
  const Type* state = call.type(at("y0"));
  const Type* function = call.type(at("f"));
  if (state == nullptr || !state->is(Kind::kRecord) || function == nullptr ||
      !function->is(Kind::kFunction))
    return;
  const std::vector<RecordField>& fields = state->record->fields;
  for (const RecordField& field : fields) {
    if (field.type->is(Kind::kReal)) continue;
    Diagnostic d = make_diagnostic("E0313", call.span(at("y0")),
                                   {"ode", "a struct of quantities", type_phrase(state)});
    d.why = fmt::format("`{}` is {}, which has no rate", field.name, type_phrase(field.type));
    call.report(std::move(d));
    return;
  }
  const Type* rates = function->result;
  const bool is_struct =
      rates->is(Kind::kRecord) && !rates->is_table() &&
      std::ranges::equal(rates->record->fields, fields, {}, &RecordField::name, &RecordField::name);
  if (!is_struct) {
    Diagnostic d = make_diagnostic(
        "E0313", call.span(at("f")),
        {"ode", fmt::format("a function that gives the rates of {}", type_phrase(state)),
         "one that gives " + type_phrase(rates)});
    d.why = "its result is a struct whose fields have the names of those of the state";
    call.report(std::move(d));
    return;
  }
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const RecordField& rate = rates->record->fields[i];
    const auto wanted = divide(fields[i].type->dim, dims::kTime);
    if (!wanted || (rate.type->is(Kind::kReal) && rate.type->dim == *wanted)) continue;
    Diagnostic d = make_diagnostic("E0401", call.span(at("f")));
    d.why = fmt::format("`{}` of the state is {}, so its rate is {}; `{}` of {} is {}", rate.name,
                        dimension_phrase(fields[i].type->dim), dimension_phrase(*wanted), rate.name,
                        type_name(rates), type_phrase(rate.type));
    call.report(std::move(d));
    return;
  }
}

namespace {

// The rows of a solution as structs; null: it failed, and the failure is set.
ListObj* structs_of(Vm& vm, const RecordObj& solution, const Type& type) {
  const MatrixObj& states = states_of(solution);
  ListObj* const list = new_list(vm, states.rows, true);
  for (std::uint32_t row = 0; list != nullptr && row < states.rows; ++row) {
    RecordObj* const state = new_record(vm, &type);
    if (state == nullptr || !charge_work(vm, 2 * states.cols)) {
      if (state != nullptr) release(vm, state);
      release(vm, list);
      return nullptr;
    }
    list->data[row].o = state;
    for (std::uint32_t i = 0; i < states.cols; ++i)
      state->fields()[i].d = states.data()[std::size_t{row} * states.cols + i];
  }
  return list;
}

// An OdeCrossing with its state as a struct; null: it failed, and the failure is set.
RecordObj* crossing_with_struct(Vm& vm, const RecordObj& crossing, const Type& state) {
  RecordObj* const out = new_record(vm, vm.program().library_record("OdeCrossing", &state));
  if (out == nullptr) return nullptr;
  out->fields()[kTime] = crossing.fields()[kTime];
  out->fields()[kEvent] = crossing.fields()[kEvent];
  RecordObj* const y = new_record(vm, &state);
  out->fields()[kState].o = y;
  if (y == nullptr) {
    release(vm, out);
    return nullptr;
  }
  const auto values = reals_value(crossing.fields()[kState]);
  for (std::size_t i = 0; i < values.size(); ++i) y->fields()[i].d = values[i];
  return out;
}

// The crossings of a solution with structs; null: it failed, and the failure is set.
ListObj* crossings_with_structs(Vm& vm, const RecordObj& solution, const Type& type) {
  const auto crossings = items_value(solution.fields()[kEvents]);
  ListObj* const list = new_list(vm, static_cast<std::uint32_t>(crossings.size()), true);
  for (std::size_t k = 0; list != nullptr && k < crossings.size(); ++k) {
    list->data[k].o =
        crossing_with_struct(vm, *static_cast<const RecordObj*>(crossings[k].o), type);
    if (list->data[k].o != nullptr) continue;
    release(vm, list);
    return nullptr;
  }
  return list;
}

}  // namespace

RecordObj* with_structs(Vm& vm, const RecordObj& solution, const Type& type) {
  RecordObj* const out = new_record(vm, vm.program().library_record("OdeSolution", &type));
  if (out == nullptr) return nullptr;
  retain(solution.fields()[kTimes].o);
  out->fields()[kTimes] = solution.fields()[kTimes];
  ListObj* const states = structs_of(vm, solution, type);
  out->fields()[kStates].o = states;
  ListObj* const events = states != nullptr ? crossings_with_structs(vm, solution, type) : nullptr;
  out->fields()[kEvents].o = events;
  if (events != nullptr) return out;
  release(vm, out);
  return nullptr;
}

Answer<std::vector<OdeWitness>> WitnessesOfProgram::witnesses() {
  std::vector<OdeWitness> out;
  for (const Slot event : events_) {
    const auto* record = static_cast<const RecordObj*>(event.o);
    const std::string_view name = text_value(record->fields()[kDirection]);
    const auto found = std::ranges::find(kDirections, name);
    if (found == kDirections.end()) {
      return failure(vm_, "R0609", fmt::format("an event cannot be \"{}\"", name), part_,
                     "it is \"both\", \"rising\" or \"falling\"");
    }
    Obj* const g = record->fields()[kFunction].o;
    out.push_back({.g =
                       [this, g](double t, std::span<const double> y, double& value) {
                         Obj* const state = y_.fill(y);
                         if (state == nullptr) return false;
                         const Slot arguments[] = {slot_of(t), slot_of(state)};
                         Slot result;
                         if (!vm_.call(g, arguments, result)) return false;
                         value = result.d;
                         return true;
                       },
                   .direction = static_cast<CrossingDirection>(found - kDirections.begin())});
  }
  return out;
}

bool WitnessesOfProgram::stops(int witness) const {
  const Slot event = events_[static_cast<std::size_t>(witness)];
  return static_cast<const RecordObj*>(event.o)->fields()[kStop].i != 0;
}

Failed WitnessesOfProgram::cannot_look(const OdeEvents::Outcome& outcome) const {
  const std::string where = fmt::format("event {} at t = {:.6g} s", outcome.witness, outcome.t);
  switch (outcome.status) {
    case OdeEvents::Status::kNotFinite:
      return failure(vm_, "R0612", fmt::format("the function of {} is not finite", where), part_);
    case OdeEvents::Status::kNoStep:
      return failure(vm_, "R0609", fmt::format("ode cannot find {}: no step leads there", where),
                     part_, "the equation is stiff there, or jumps, or runs to infinity");
    default:
      return {};
  }
}

RecordObj* new_solution(Vm& vm, std::uint32_t rows, std::uint32_t columns) {
  RecordObj* solution = new_record(vm, vm.program().library_record("OdeSolution"));
  if (solution == nullptr) return nullptr;
  ListObj* const times = new_list(vm, rows, false);
  solution->fields()[0].o = times;
  MatrixObj* const states = times != nullptr ? new_matrix(vm, rows, columns) : nullptr;
  solution->fields()[1].o = states;
  ListObj* const events = states != nullptr ? new_list(vm, 0, true) : nullptr;
  solution->fields()[2].o = events;
  if (events != nullptr) return solution;
  release(vm, solution);
  return nullptr;
}

RecordObj* shortened(Vm& vm, const RecordObj& solution, std::uint32_t rows) {
  const MatrixObj& states = states_of(solution);
  RecordObj* const part = new_solution(vm, rows, states.cols);
  if (part == nullptr) return nullptr;
  std::copy_n(times_of(solution).data, rows, times_of(*part).data);
  std::copy_n(states.data(), std::size_t{rows} * states.cols, states_of(*part).data());
  return part;
}

Answer<void> set_crossings(Vm& vm, RecordObj& solution, const std::vector<OdeCrossing>& crossings) {
  ListObj* const list = new_list(vm, static_cast<std::uint32_t>(crossings.size()), true);
  if (list == nullptr) return Failed{};
  release(vm, solution.fields()[2].o);
  solution.fields()[2].o = list;
  for (std::uint32_t k = 0; k < list->size; ++k) {
    RecordObj* const crossing = new_record(vm, vm.program().library_record("OdeCrossing"));
    if (crossing == nullptr) return Failed{};
    list->data[k].o = crossing;
    ListObj* const y = new_list(vm, static_cast<std::uint32_t>(crossings[k].y.size()), false);
    if (y == nullptr) return Failed{};
    for (std::uint32_t i = 0; i < y->size; ++i) y->data[i].d = crossings[k].y[i];
    crossing->fields()[0] = slot_of(crossings[k].t);
    crossing->fields()[1] = slot_of(std::int64_t{crossings[k].witness});
    crossing->fields()[2].o = y;
  }
  return {};
}

}  // namespace armlet::bind
