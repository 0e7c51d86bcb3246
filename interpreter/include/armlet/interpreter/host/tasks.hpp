#pragma once
// Tasks that the host starts beside a program, and calls that only read, in a run that continues
// after the end of its program (VmOptions::stays):
//
//     start_task(vm, "panel.run");             // a variable with a function: fn() -> void
//     vm.run({.until_ns = t});                 // the task runs like any other
//     if (is_at_rest(vm)) finish(vm);
//
// All of these are called between two slices of the run.

#include <span>
#include <string_view>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/value.hpp"
#include "armlet/interpreter/host/vm.hpp"

namespace armlet {

// Starts the function in a global variable. It begins at the current instant, as the newest task.
// VmOptions::on_task_end reports its end.
//
// returns  an error if the limit of tasks is reached.
// throws   ArgumentError if there is no such variable, if its value is not a function without
//          parameters or not set yet, if the run does not wait for its host, and if it has ended.
std::optional<Error> start_task(Vm& vm, std::string_view variable);

// Whether the program has ended and no task is running, so that only time passes until the host
// acts.
[[nodiscard]] bool is_at_rest(Vm& vm);

// Ends a run that is at rest; its status becomes kDone.
//
// throws  ArgumentError if it is not at rest.
void finish(Vm& vm);

// The result of a function in a variable for these arguments, at the current instant. The run is
// unchanged afterwards: its variables, its random numbers, its steps and its output.
//
// returns  an error with the message if it fails.
// throws   ArgumentError as start_task, but in any run, and for arguments of other types.
[[nodiscard]] Result<Value> read_function(Vm& vm, std::string_view variable,
                                          std::span<const Value> arguments = {});

// Whether such a call is running: a function of the library must then leave no trace.
[[nodiscard]] bool is_reading(Vm& vm);

}  // namespace armlet
