// The functions of a program that an integration calls, and the results that the program gets.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "armlet/math/ode_events.hpp"
#include "values/bind.hpp"
#include "values/blocks.hpp"

namespace armlet::bind {

// The state as the list, or struct of quantities, that a function of the program gets; a new one is
// made if the program stored the last one.
class StateArgument {
 public:
  // `record`: the type of the struct; null: a list.
  StateArgument(Vm& vm, const Type* record) : vm_(vm), type_(record) {}
  ~StateArgument() { release(vm_, state_); }
  StateArgument(const StateArgument&) = delete;
  StateArgument& operator=(const StateArgument&) = delete;

  // Null: it failed, and the failure is set.
  [[nodiscard]] Obj* fill(std::span<const double> y);

 private:
  Vm& vm_;
  const Type* type_;
  Obj* state_ = nullptr;
};

// The program's f(t, y); its result is copied from the list that it returns. Failures mark
// `part`.
class RateOfProgram {
 public:
  RateOfProgram(Vm& vm, Obj* f, CallPart part) : vm_(vm), f_(f), part_(part), y_(vm, nullptr) {}
  Answer<void> operator()(double t, std::span<const double> y, std::span<double> rate);

 private:
  Vm& vm_;
  Obj* f_;
  CallPart part_;
  StateArgument y_;
};

// The program's f(t, y) if the state and its rates are structs of quantities, field by field.
class RateOfStructs {
 public:
  RateOfStructs(Vm& vm, Obj* f, const Type& state) : vm_(vm), f_(f), y_(vm, &state) {}
  Answer<void> operator()(double t, std::span<const double> y, std::span<double> rate);

 private:
  Vm& vm_;
  Obj* f_;
  StateArgument y_;
};
// Checks that each field of the result of f has the name of a field of y0 and its unit per second.
void check_rates(CheckCall& call);
// An OdeSolution<S> with the times of a solution, and its rows and event states as structs of this
// type; null: it failed, and the failure is set.
[[nodiscard]] RecordObj* with_structs(Vm& vm, const RecordObj& solution, const Type& type);

// The events that a program waits for in an integration: a list of OdeEvent, or of OdeEvent<S>.
class WitnessesOfProgram {
 public:
  // `events` is borrowed; `part` is the argument of the call that holds them; `record`: the
  // struct of the states, null: lists.
  WitnessesOfProgram(Vm& vm, std::span<const Slot> events, CallPart part, const Type* record)
      : vm_(vm), events_(events), part_(part), y_(vm, record) {}

  [[nodiscard]] bool empty() const { return events_.empty(); }
  // Fails for an unknown direction.
  Answer<std::vector<OdeWitness>> witnesses();
  [[nodiscard]] bool stops(int witness) const;

  // The failure: a witness is not a number, or an equation cannot be followed to the zero.
  Failed cannot_look(const OdeEvents::Outcome& outcome) const;

 private:
  Vm& vm_;
  std::span<const Slot> events_;
  CallPart part_;
  StateArgument y_;
};

// An OdeSolution with memory for the state at `rows` times and no events; null: it failed.
[[nodiscard]] RecordObj* new_solution(Vm& vm, std::uint32_t rows, std::uint32_t columns);
// A solution without the rows from `rows` on.
[[nodiscard]] RecordObj* shortened(Vm& vm, const RecordObj& solution, std::uint32_t rows);
// Stores the events that happened.
Answer<void> set_crossings(Vm& vm, RecordObj& solution, const std::vector<OdeCrossing>& crossings);

[[nodiscard]] inline ListObj& times_of(const RecordObj& solution) {
  return *static_cast<ListObj*>(solution.fields()[0].o);
}
[[nodiscard]] inline MatrixObj& states_of(const RecordObj& solution) {
  return *static_cast<MatrixObj*>(solution.fields()[1].o);
}

}  // namespace armlet::bind
