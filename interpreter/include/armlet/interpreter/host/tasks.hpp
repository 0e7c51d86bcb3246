#pragma once
// Tasks that the host starts beside a program, and functions that it reads, in a run that waits for
// it at the end of the program (VmOptions::stays):
//
//     start_task(vm, "panel.run");             // what the variable holds: fn() -> void
//     vm.run({.until_ns = t});                 // the task runs like any other
//     if (is_at_rest(vm)) finish(vm);
//
// All of it between two slices of the run.

#include <span>
#include <string_view>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/value.hpp"
#include "armlet/interpreter/host/vm.hpp"

namespace armlet {

// Starts the function that a variable of the top level holds. It begins at this instant, as the
// newest task. Its end is told by VmOptions::on_task_end.
//
// returns  an error if there cannot be another task.
// throws   ArgumentError if there is no such variable, or it has no value yet or none that is a
//          function without parameters, if the run does not wait for its host, and if it has ended.
std::optional<Error> start_task(Vm& vm, std::string_view variable);

// Whether the program has ended and no task runs: time alone passes before the host does something.
[[nodiscard]] bool is_at_rest(Vm& vm);

// Ends a run that is at rest; it is done.
//
// throws  ArgumentError if it is not at rest.
void finish(Vm& vm);

// What a function gives now that a variable holds, for these arguments. The run is afterwards as it
// was before: its variables, its chance, its steps and its output.
//
// returns  an error with the message of its failure.
// throws   ArgumentError as start_task, but in any run, and for arguments of other types.
[[nodiscard]] Result<Value> read_function(Vm& vm, std::string_view variable,
                                          std::span<const Value> arguments = {});

// Whether that is under way: a function of the library may leave no trace then.
[[nodiscard]] bool is_reading(Vm& vm);

}  // namespace armlet
