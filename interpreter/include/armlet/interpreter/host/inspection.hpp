#pragma once
// The state of a run that is paused or has ended: its variables, its tasks, and the operations that
// each of them waits for.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/vm.hpp"

namespace armlet {

// value  the text that `print` shows, shortened if it is long; empty: no value yet.
struct SeenVariable {
  std::string name;
  std::string type;
  std::string value;
  Span declared{};
};

// A running call: the function's name, empty for the program and the blocks of tasks; its current
// statement or expression; and in a program with markers the variables that are visible there, the
// innermost scope last.
struct SeenCall {
  std::string function;
  Span at{};
  std::vector<SeenVariable> variables{};
};

// name   "branch 2 of parallel on line 9"; empty: the program itself.
// waits  the operation that it waits for; empty: it is running, or waits for tasks that it started.
// calls  the innermost first.
struct SeenTask {
  std::string name;
  std::string waits;
  std::vector<SeenCall> calls;
};

// The global variables that hosts can read (CompileOptions::open), in the order of their
// declarations.
//
// throws  ArgumentError while the Vm is running, and before its run. The same for the other
//         functions.
[[nodiscard]] std::vector<SeenVariable> seen_variables(Vm& vm);
// The program itself first, then the other tasks in the order of their start; empty when the run
// has ended.
[[nodiscard]] std::vector<SeenTask> seen_tasks(Vm& vm);

// The value of an expression in a paused run.
struct SeenValue {
  Span at{};  // the expression
  std::string type;
  std::string value;
};

// The value of the innermost expression around a byte of a text of the program. It is computed in
// the innermost running call whose function contains that text: of the paused task first, then of
// the others. If there is no such call, only global variables can be read. The run is unchanged
// afterwards: functions that act, take time or change variables and values are not called.
//
// returns  an error with the reason if there is no value: there is no expression, a variable has no
//          value yet, the evaluation would change a value, or it fails, with the message of the
//          failure.
// throws   ArgumentError as seen_variables.
[[nodiscard]] Result<SeenValue> value_at(Vm& vm, std::uint32_t source, std::uint32_t byte);

// The position of a task in the text.
//
// name  as in SeenTask; of a task that the host has started, the variable with its function.
// at    the statement or expression of its innermost call; empty: it has not begun.
struct TaskPlace {
  std::string name;
  Span at{};
  bool operator==(const TaskPlace&) const = default;
};
// The program itself first, then the other tasks in the order of their start. May be called while
// the Vm is running, by backends and host functions.
[[nodiscard]] std::vector<TaskPlace> task_places(Vm& vm);

// The position of the task that is running or was running last; empty: none has begun. May be
// called while the Vm is running, by backends and host functions.
[[nodiscard]] Span running_at(Vm& vm);

}  // namespace armlet
