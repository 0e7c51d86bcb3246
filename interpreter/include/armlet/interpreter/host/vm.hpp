#pragma once
// Runs programs. A Vm belongs to one thread at a time; only `cancel` may be called by another
// thread. Nothing here throws for what a script does.

#include <atomic>
#include <concepts>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/host/memory.hpp"
#include "armlet/interpreter/host/program.hpp"
#include "armlet/interpreter/native.hpp"
#include "armlet/interpreter/output.hpp"
#include "armlet/interpreter/run.hpp"

namespace armlet {

class Value;
template <class Signature>
class ProgramFunction;

struct VmOptions {
  RunLimits limits;
  Timeline* timeline = nullptr;                   // null: a clock without a world
  void* host = nullptr;                           // what native functions find with Vm::host
  Output output;                                  // what `print` writes
  Memory memory;                                  // where its values lie; none: of the C library
  std::function<void(const Diagnostic&)> advice;  // advice given while running
  bool stays = false;  // where the program has ended it waits for its host (host/tasks.hpp)
  std::function<void(const TaskEnd&)> on_task_end;
};

// What a prompt shows after an entry: `let w = 80mm` as "w = 80 mm  length", an
// expression as "100 mm  length".
struct EntryValue {
  std::string name;  // that the entry declares; empty: the value of an expression, kept as `ans`
  std::string text;  // as `print` shows it, with its unit; texts in quotes; cut after 2,000 bytes
  std::string type;
};

class Vm {
 public:
  explicit Vm(std::shared_ptr<const Program> program, VmOptions options = {});
  ~Vm();
  Vm(const Vm&) = delete;
  Vm& operator=(const Vm&) = delete;

  // Runs the program's text, from the start or from where it paused, until it has ended or the
  // budget is used. It pauses before calls, at passes of loops and where virtual time passes, never
  // inside a function of the host that calls the program. A Vm runs its program once; make a new
  // one to run it again. What the program leaves, its variables and functions, stays until the Vm
  // goes.
  //
  // throws  ArgumentError for a budget of no steps, when the run has ended, and while it runs: in
  //         another thread, or in the function of the host that calls this. All stays as it was.
  Progress run(const Budget& budget);
  // The same without a budget.
  [[nodiscard]] RunResult run();
  // Runs top-level declarations' initialisers that test `index` needs, then its body.
  [[nodiscard]] RunResult run_test(std::size_t index);
  // After an entry (CompileOptions::is_entry) has run, lets the next one begin: `run` runs it. Its
  // variables, functions and armed `when` and `every` live on. An entry that fails leaves all
  // variables as they were before it, and counts as if it had not been: the next one is compiled
  // behind the same one as it.
  //
  // throws  ArgumentError if the entry was not compiled behind the newest one that has run to its
  //         end here, or an entry is running.
  void begin(std::shared_ptr<const Program> entry);
  // The newest entry that has run to its end; null: none has.
  [[nodiscard]] const std::shared_ptr<const Program>& newest_entry() const { return done_; }
  // The value of its last statement; nothing: it has none, or a semicolon follows.
  [[nodiscard]] std::optional<EntryValue> shown() const;
  // How far the run has come; kPaused before its start.
  [[nodiscard]] const RunResult& result() const { return result_; }
  // From any thread or a signal handler: the program stops at its next pause point or step check.
  // Where nothing runs or is paused, the next call drops the request.
  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }

  // ---- functions and variables by name, while the program is not running (globals.hpp)

  // throws  ArgumentError with both signatures if there is no function of these types; the other
  //         gives it as a result.
  template <class Signature>
  [[nodiscard]] ProgramFunction<Signature> function(std::string_view name);
  template <class Signature>
  [[nodiscard]] Result<ProgramFunction<Signature>> try_function(std::string_view name);
  // Why the run or the last call that failed did, also as people read it; null and empty: none has.
  [[nodiscard]] const Diagnostic* error() const;
  [[nodiscard]] std::string error_text() const;
  // A variable of the top level: as a Value, or as a type of C++.
  //
  // throws  ArgumentError if there is none with this name and type, it has no value yet, or the
  //         program runs; the others give that as a result.
  [[nodiscard]] Value global(std::string_view name);
  template <class T>
  [[nodiscard]] T global(std::string_view name);
  [[nodiscard]] Result<Value> try_global(std::string_view name);
  void set(std::string_view name, const Value& value);
  void set(std::string_view name, double number, std::string_view unit);
  template <class T>  // a type of the host
  requires(!std::convertible_to<const T&, Value>) void set(std::string_view name, const T& value);
  [[nodiscard]] std::optional<Error> try_set(std::string_view name, const Value& value);

  // ---- for native functions
  [[nodiscard]] void* host() const { return options_.host; }
  [[nodiscard]] Timeline& timeline() { return *timeline_; }
  [[nodiscard]] const Program& program() const { return *program_; }
  [[nodiscard]] const VmOptions& options() const { return options_; }
  // What the host keeps for the running task, such as the settings of `with`; a task begins with
  // what the task had that started it.
  [[nodiscard]] std::shared_ptr<const void>& task_data();
  // Calls a function value; it may not pause. False: it failed, and the failure is set.
  [[nodiscard]] bool call(Obj* function, std::span<const Slot> arguments, Slot& result);
  // Advice at the call that is running now.
  void advise(const Failure& advice);
  // Writes output, in pieces if it is long. False: the limit of output is reached, it could not be
  // written, or the program has to stop; the failure is set.
  [[nodiscard]] bool print(std::string_view text);
  // Chance for the running task: each branch of a `parallel` has a stream of its own.
  [[nodiscard]] Random& random();
  // Begins its stream anew, and those of the branches that it starts from here on.
  void seed(std::uint64_t seed);
  // Whether somebody has asked to cancel since this was asked last.
  [[nodiscard]] bool take_cancellation() noexcept {
    return cancelled_.load() && cancelled_.exchange(false);
  }
  struct State;  // the interpreter's own
  [[nodiscard]] State& state() { return *state_; }

 private:
  friend class ReadyFunction;
  friend void finish(Vm& vm);
  Progress go_on(std::uint32_t function, const Budget& budget);
  void begin_call(std::uint32_t function, std::vector<Slot> arguments);
  void finish_entry();

  std::shared_ptr<const Program> program_;
  std::shared_ptr<const Program> done_;  // the newest entry that has run to its end
  VmOptions options_;
  std::unique_ptr<Timeline> own_timeline_;
  Timeline* timeline_;
  std::unique_ptr<State> state_;
  RunResult result_{.status = Progress::kPaused, .error = {}, .steps = 0};
  std::uint64_t steps_before_ = 0;
  std::atomic<bool> cancelled_{false};
};

// A function of the program that the running native function calls, perhaps many times: what all
// these calls have in common is looked up once. It lives in the native function and no longer;
// while it does, functions of the program may not pause.
class PreparedCall {
 public:
  PreparedCall(Vm& vm, Obj* function);
  PreparedCall(const PreparedCall&) = delete;
  PreparedCall& operator=(const PreparedCall&) = delete;
  ~PreparedCall();
  // The arguments go here, one slot for each parameter; the first one then holds the result.
  [[nodiscard]] Slot* window() const { return window_; }
  struct Outcome {
    bool done;            // false: the call failed, and the failure is set in the Vm
    double result = 0.0;  // if it is a double; sooner than from the window
  };
  [[nodiscard]] Outcome run() const;

 private:
  Vm::State& state_;
  void* task_;
  void* below_;
  const void* code_;
  Slot* window_;
  const void* callee_;
  ClosureObj* function_;
};
}  // namespace armlet
