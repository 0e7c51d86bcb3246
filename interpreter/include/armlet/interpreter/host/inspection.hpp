#pragma once
// What a run that has paused or ended looks like from outside: its variables, its tasks, and what
// each of them waits for.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/vm.hpp"

namespace armlet {

// value  as `print` shows it, cut when it is long; empty: it has none yet.
struct SeenVariable {
  std::string name;
  std::string type;
  std::string value;
  Span declared{};
};

// A call under way: the function's name, empty for the program and the blocks of tasks, the
// statement or expression that it has come to, and in a program with markers its variables that can
// be seen there, the innermost scope last.
struct SeenCall {
  std::string function;
  Span at{};
  std::vector<SeenVariable> variables{};
};

// name   "branch 2 of parallel on line 9"; empty: the program itself.
// waits  what it waits for; empty: it runs, or waits for the tasks that it has started.
// calls  the innermost first.
struct SeenTask {
  std::string name;
  std::string waits;
  std::vector<SeenCall> calls;
};

// The variables of the top level that hosts can ask for (CompileOptions::open), as declared.
//
// throws  ArgumentError while the Vm runs, and before its run. The same for the others.
[[nodiscard]] std::vector<SeenVariable> seen_variables(Vm& vm);
// The program itself first, then the others as they were started; none when the run has ended.
[[nodiscard]] std::vector<SeenTask> seen_tasks(Vm& vm);

// What an expression gives where a run has paused.
struct SeenValue {
  Span at{};  // the expression
  std::string type;
  std::string value;
};

// The value of the innermost expression around a byte of a text of the program, computed now in the
// innermost call under way whose function has that text: of the task that has paused, then of the
// others. Where none is under way only variables of the top level can be read. The run is
// afterwards as it was: functions that act, take time or change variables and values are not
// called.
//
// returns  an error that says why there is no value: no expression stands there, a variable has
//          none yet, something would be changed, or computing it fails, with the message of that
//          failure.
// throws   ArgumentError as seen_variables.
[[nodiscard]] Result<SeenValue> value_at(Vm& vm, std::uint32_t source, std::uint32_t byte);

// Where a task is in the text.
//
// name  as in SeenTask; of a task that the host has started, the variable with its function.
// at    the statement or expression of its innermost call; empty: it has not begun.
struct TaskPlace {
  std::string name;
  Span at{};
  bool operator==(const TaskPlace&) const = default;
};
// The program itself first, then the others as they were started. Also for backends and functions
// of the host, while the Vm runs.
[[nodiscard]] std::vector<TaskPlace> task_places(Vm& vm);

// Where the task is that runs, or has run last; empty: nowhere yet. Also for backends and functions
// of the host, while the Vm runs.
[[nodiscard]] Span running_at(Vm& vm);

}  // namespace armlet
