#pragma once
// Helpers shared by the functions of dynamics.

#include "messages/library_messages.hpp"
#include "values/bind.hpp"
#include "values/robots/robot_state.hpp"

namespace armlet::bind {

// The model of the arm with its payload.
inline const Robot& loaded_of(Vm& vm, const RobotRef& r) { return *state_of(vm, r).loaded; }

// law() with its ArgumentError as R0640.
template <class Result, class Law>
Answer<Result> dynamics_of(Vm& vm, const Law& law) try {
  return Answer<Result>(law());
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0640"), error);
}

}  // namespace armlet::bind
