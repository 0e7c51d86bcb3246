// The functions of a program that an integration calls, and what it gives back.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "armlet/math/ode_events.hpp"
#include "session/bind.hpp"
#include "values/blocks.hpp"

namespace armlet::bind {

// The state as a list that a function of the program gets, or as a struct of quantities; made anew
// if the program keeps it.
class StateArgument {
 public:
  // `record`: the type of the struct; null: a list.
  StateArgument(Vm& vm, const Type* record) : vm_(vm), type_(record) {}
  ~StateArgument() { release(vm_, state_); }
  StateArgument(const StateArgument&) = delete;
  StateArgument& operator=(const StateArgument&) = delete;

  // Null: the failure is set.
  [[nodiscard]] Obj* fill(std::span<const double> y);

 private:
  Vm& vm_;
  const Type* type_;
  Obj* state_ = nullptr;
};

// The program's f(t, y), its result copied out of the list that it gives. `parameter` is marked in
// failures.
class RateOfProgram {
 public:
  RateOfProgram(Vm& vm, Obj* f, int parameter)
      : vm_(vm), f_(f), parameter_(parameter), y_(vm, nullptr) {}
  Answer<void> operator()(double t, std::span<const double> y, std::span<double> rate);

 private:
  Vm& vm_;
  Obj* f_;
  int parameter_;
  StateArgument y_;
};

// The same where the state and its rates are structs of quantities, field by field.
class RateOfStructs {
 public:
  RateOfStructs(Vm& vm, Obj* f, const Type& state) : vm_(vm), f_(f), y_(vm, &state) {}
  Answer<void> operator()(double t, std::span<const double> y, std::span<double> rate);

 private:
  Vm& vm_;
  Obj* f_;
  StateArgument y_;
};
// Each field of what f gives has the name of one of y0 and its unit per second.
void check_rates(CheckCall& call);
// An OdeSolution<S> with the times of a solution, its rows and the states of its events as structs
// of this type; null: the failure is set.
[[nodiscard]] RecordObj* with_structs(Vm& vm, const RecordObj& solution, const Type& type);

// What a program waits for in an integration: a list of OdeEvent, or of OdeEvent<S>.
class WitnessesOfProgram {
 public:
  // `events` is borrowed; `parameter` is the one of the call that holds them; `record`: the struct
  // that states are, null: lists.
  WitnessesOfProgram(Vm& vm, std::span<const Slot> events, int parameter, const Type* record)
      : vm_(vm), events_(events), parameter_(parameter), y_(vm, record) {}

  [[nodiscard]] bool empty() const { return events_.empty(); }
  // Fails for a direction that there is not.
  Answer<std::vector<OdeWitness>> witnesses();
  [[nodiscard]] bool stops(int witness) const;

  // As a failure: a witness that is no number, an equation that cannot be followed to the zero.
  Failed cannot_look(const OdeEvents::Outcome& outcome) const;

 private:
  Vm& vm_;
  std::span<const Slot> events_;
  int parameter_;
  StateArgument y_;
};

// An OdeSolution with room for the state at `rows` instants and no events; null: it failed.
[[nodiscard]] RecordObj* new_solution(Vm& vm, std::uint32_t rows, std::uint32_t columns);
// The same up to row `rows`.
[[nodiscard]] RecordObj* shortened(Vm& vm, const RecordObj& solution, std::uint32_t rows);
// Puts in what happened.
Answer<void> set_crossings(Vm& vm, RecordObj& solution, const std::vector<OdeCrossing>& crossings);

[[nodiscard]] inline ListObj& times_of(const RecordObj& solution) {
  return *static_cast<ListObj*>(solution.fields()[0].o);
}
[[nodiscard]] inline MatrixObj& states_of(const RecordObj& solution) {
  return *static_cast<MatrixObj*>(solution.fields()[1].o);
}

}  // namespace armlet::bind
