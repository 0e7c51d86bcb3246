#pragma once
// Runs programs. A Vm belongs to one thread at a time; only `cancel` may be called by another
// thread. Mistakes of a program cause no exceptions here.

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
  Timeline* timeline = nullptr;  // null: a clock without a world
  void* host = nullptr;          // for native functions, which read it with Vm::host
  Output output;                 // the destination of `print`
  Memory memory;                 // for its values; null: of the C library
  std::function<void(const Diagnostic&)> advice;  // called with advice at run time
  bool stays = false;  // after the end of the program the run waits for its host (host/tasks.hpp)
  std::function<void(const TaskEnd&)> on_task_end;
};

// The text that a prompt shows after an entry: `let w = 80mm` as "w = 80 mm  length", an expression
// as "100 mm  length".
struct EntryValue {
  std::string name;  // of the declared variable; empty: the value of an expression, kept as `ans`
  std::string text;  // as `print` shows it, with its unit; texts in quotes; at most 2,000 bytes
  std::string type;
};

class Vm {
 public:
  explicit Vm(std::shared_ptr<const Program> program, VmOptions options = {});
  ~Vm();
  Vm(const Vm&) = delete;
  Vm& operator=(const Vm&) = delete;

  // Runs the program, from the start or from its last pause, until it has ended or the budget is
  // used up. It pauses before calls, at iterations of loops and where virtual time passes, never
  // inside a host function that calls the program. A Vm runs its program once; make a new Vm to run
  // it again. The variables and functions of the program stay until the Vm is destroyed.
  //
  // throws  ArgumentError for a budget of no steps, when the run has ended, and while it is
  //         running, in another thread or in the host function that makes this call. The Vm is then
  //         unchanged.
  Progress run(const Budget& budget);
  // Runs it without a budget.
  [[nodiscard]] RunResult run();
  // Runs the initialisers of the global variables that test `index` needs, then the test.
  [[nodiscard]] RunResult run_test(std::size_t index);
  // After an entry (CompileOptions::is_entry) has run, begins the next one, which `run` then
  // executes. The variables, functions and armed `when` and `every` of earlier entries stay. An
  // entry that fails is undone: all variables have their values from before, and the next entry has
  // to be compiled after the same entry as the failed one.
  //
  // throws  ArgumentError if the entry was not compiled after the newest one that has run to its
  //         end in this Vm, or if an entry is running.
  void begin(std::shared_ptr<const Program> entry);
  // The newest entry that has run to its end; null if there is none.
  [[nodiscard]] const std::shared_ptr<const Program>& newest_entry() const { return done_; }
  // The value of its last statement; empty if it has none, or if a semicolon follows.
  [[nodiscard]] std::optional<EntryValue> shown() const;
  // The state of the run; kPaused before its start.
  [[nodiscard]] const RunResult& result() const { return result_; }
  // May be called by any thread or signal handler: the program stops at its next pause or check of
  // steps. If no program is running or paused, the next call drops the request.
  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }

  // ---- functions and variables by name, while the program is not running (globals.hpp)

  // throws  ArgumentError with both signatures if there is no function of these types; the other
  // overload returns the error.
  template <class Signature>
  [[nodiscard]] ProgramFunction<Signature> function(std::string_view name);
  template <class Signature>
  [[nodiscard]] Result<ProgramFunction<Signature>> try_function(std::string_view name);
  // The message of the failure of the run or of the last call, and its text; null and empty if
  // there is none.
  [[nodiscard]] const Diagnostic* error() const;
  [[nodiscard]] std::string error_text() const;
  // A global variable: as a Value, or as a C++ type.
  //
  // throws  ArgumentError if there is none with this name and type, it has no value yet, or the
  //         program is running; the other overloads return the error.
  [[nodiscard]] Value global(std::string_view name);
  template <class T>
  [[nodiscard]] T global(std::string_view name);
  [[nodiscard]] Result<Value> try_global(std::string_view name);
  void set(std::string_view name, const Value& value);
  void set(std::string_view name, double number, std::string_view unit);
  template <class T>  // a host type
  requires(!std::convertible_to<const T&, Value>) void set(std::string_view name, const T& value);
  [[nodiscard]] std::optional<Error> try_set(std::string_view name, const Value& value);

  // ---- for native functions
  [[nodiscard]] void* host() const { return options_.host; }
  [[nodiscard]] Timeline& timeline() { return *timeline_; }
  [[nodiscard]] const Program& program() const { return *program_; }
  [[nodiscard]] const VmOptions& options() const { return options_; }
  // Data of the host for the running task, such as the settings of `with`; a new task begins with
  // the data of the task that started it.
  [[nodiscard]] std::shared_ptr<const void>& task_data();
  // Calls a function value, which must not pause. Returns false, with the failure set, if it
  // failed.
  [[nodiscard]] bool call(Obj* function, std::span<const Slot> arguments, Slot& result);
  // Reports advice at the running call.
  void advise(const Failure& advice);
  // Writes output, in pieces if it is long. Returns false, with the failure set, if the limit of
  // output is reached, if the output could not be written, or if the program has to stop.
  [[nodiscard]] bool print(std::string_view text);
  // The random numbers of the running task: each branch of a `parallel` has its own stream.
  [[nodiscard]] Random& random();
  // Starts the task's stream again from a seed, and those of the branches that it starts from here
  // on.
  void seed(std::uint64_t seed);
  // Whether a stop request has arrived since the last call.
  [[nodiscard]] bool take_cancellation() noexcept {
    return cancelled_.load() && cancelled_.exchange(false);
  }
  struct State;  // internal
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

// A function of the program that the running native function calls, perhaps many times. The
// preparations that all calls share are made once. Its lifetime must be inside of the native
// function, and during it functions of the program must not pause.
class PreparedCall {
 public:
  PreparedCall(Vm& vm, Obj* function);
  PreparedCall(const PreparedCall&) = delete;
  PreparedCall& operator=(const PreparedCall&) = delete;
  ~PreparedCall();
  // The slots for the arguments, one for each parameter; after a call the first one has the result.
  [[nodiscard]] Slot* window() const { return window_; }
  struct Outcome {
    bool done;            // false: the call failed, and the failure is set
    double result = 0.0;  // set if the result is a double; faster than the window
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
