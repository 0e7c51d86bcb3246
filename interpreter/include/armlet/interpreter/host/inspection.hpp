#pragma once
// What a run that has paused or ended looks like from outside: its variables, its tasks, and what
// each of them waits for.

#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/engine.hpp"

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

// Where the task is that runs, or has run last; empty: nowhere yet. Also for backends and functions
// of the host, while the Vm runs.
[[nodiscard]] Span running_at(Vm& vm);

}  // namespace armlet
