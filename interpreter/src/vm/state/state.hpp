#pragma once
// The state of a running Vm, and operations on it that several parts share.

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "armlet/core/checkpoint.hpp"
#include "armlet/interpreter/failure.hpp"
#include "armlet/interpreter/host/instants.hpp"
#include "armlet/interpreter/host/stepping.hpp"
#include "armlet/interpreter/host/vm.hpp"
#include "vm/heap/heap.hpp"
#include "vm/state/entries.hpp"
#include "vm/state/run_counts.hpp"
#include "vm/state/task.hpp"
#include "vm/state/task_tree.hpp"

namespace armlet::lang {

// The handlers that a failure runs. With two failures the one with the larger value has priority.
enum class Reach : std::uint8_t {
  kHandlers,  // the nearest catch or finally
  kFinally,   // only finally blocks: the program is being stopped
  kNothing,   // none
};

struct Fault {
  Diagnostic diagnostic;
  std::string kind;  // as e.kind shows it
  Reach reach = Reach::kHandlers;
  bool cancelled = false;
  bool is_leaving = false;         // the whole program ends with it
  std::size_t region = kNoRegion;  // kFinally: the failure ends at this watched block of its task
  std::shared_ptr<const FailureDetail> detail{};
};
using FaultPtr = std::shared_ptr<Fault>;

// Counts calls and backward jumps. The instruction loop only decrements `left`; after each chunk
// the limit of steps and stop requests are checked.
struct StepMeter {
  static constexpr std::uint64_t kChunk = 4096;

  std::int64_t left = 0;               // of the running chunk; below 0 it is used up
  std::int64_t chunk = 0;              // size of the running chunk
  std::uint64_t total = 0;             // before the running chunk
  std::uint64_t since_pause = 0;       // the same, since the last pause
  std::uint64_t limit = 0;             // between two pauses
  std::uint64_t slice_end = kEndless;  // the total at which the run returns to its host
  std::uint64_t look_at = kEndless;    // the total at which stop requests are checked

  static constexpr std::uint64_t kEndless = std::numeric_limits<std::uint64_t>::max();

  // The total with the steps of the running chunk.
  [[nodiscard]] std::uint64_t so_far() const {
    return total + static_cast<std::uint64_t>(chunk - left);
  }
  // Adds the steps of the running chunk to the totals and ends the chunk.
  void settle() {
    const auto done = static_cast<std::uint64_t>(chunk - left);
    total += done;
    since_pause += done;
    chunk = left = 0;
  }
  // Starts a new chunk; false if the limit is reached.
  [[nodiscard]] bool refill();
  // Whether the slice has ended. Adds the running chunk to the totals.
  [[nodiscard]] bool slice_is_over() {
    settle();
    return total >= slice_end;
  }
  void begin_slice(std::uint64_t steps) {
    settle();
    slice_end = steps < kEndless - total ? total + steps : kEndless;
  }
  // Counts an operation that takes as long as `steps` steps. The limits are checked at the next
  // step.
  void book(std::uint64_t steps) {
    settle();
    total += steps;
    since_pause += steps;
  }
  // A call by the host has the same limit of steps as the program between two pauses. The
  // difference cancels the steps of the running chunk when the chunk is settled.
  void begin_call() { since_pause = static_cast<std::uint64_t>(left - chunk); }
};

class Recordings;
class Scheduler;

// Counts the statements of programs with markers, and has the conditions for a pause of a debugger.
struct Marks {
  std::uint64_t begun = 0;
  std::uint64_t pause_at = StepMeter::kEndless;  // pause before the statement with this number
  std::vector<SourceLine> breakpoints;           // sorted
  bool is_at_breakpoint = false;                 // the run has paused at one
  const Task* paused = nullptr;  // the task that is paused before a MARK instruction
};

// Counts the work of the library's kernels as steps.
class KernelWork final : public Supervisor {
 public:
  explicit KernelWork(Vm& vm) : vm_(vm) {}
  [[nodiscard]] bool go_on(std::uint64_t operations) override;
  // Operations that are less than one step together.
  [[nodiscard]] std::uint64_t rest() const { return rest_; }
  void set_rest(std::uint64_t rest) { rest_ = rest; }

 private:
  Vm& vm_;
  std::uint64_t rest_ = 0;
};

// An address that identifies the current thread. It is faster than asking the system.
[[nodiscard]] inline const void* this_thread() { return &armlet::detail::present_supervisor; }

// A substitute for a row that its list does not have. Instruction ROW looks rows up before a loop,
// which fails only if it uses the row.
struct MissingRow : ListObj {
  std::int64_t index;
  std::uint64_t rows;  // the count of rows
  const Instr* at;     // where it was looked up
};

// The last entry that was found in a map.
struct LastEntry {
  const MapEntry* entries = nullptr;  // of the map, which may no longer exist
  std::uint32_t number = 0;
};

// Objects that are made once, or that are not on the heap.
struct SharedObjects {
  static constexpr std::size_t kMissingRows = 8;  // in one loop

  using Ascii = std::array<Obj*, 128>;
  static constexpr Ascii kNoAscii{};

  // Texts of one character, each made at its first use, in an array that is made with the first of
  // them.
  const Ascii* ascii = &kNoAscii;
  std::unique_ptr<Ascii> made_ascii{};
  LastEntry last_entry = {};
  MissingRow missing_rows[kMissingRows] = {};  // used only by loops without calls
  // Copies of large lists, by instruction.
  std::unordered_map<const Instr*, std::uint32_t> large_copies{};
};

// A call of a function that runs like a program, with the objects among its arguments.
struct BegunCall {
  std::uint32_t function;
  std::vector<Obj*> kept;
};

// The programs that this virtual machine has run.
struct Programs {
  const CompiledProgram* newest;
  std::vector<Callee> callees{};                     // by number of the function
  std::unique_ptr<Before> before{};                  // of the entry that runs; null: none
  std::vector<std::unique_ptr<LoadedCode>> units{};  // those whose code may still run
};

// The global variables, by their numbers.
struct Globals {
  std::vector<Slot> values{};
  std::vector<std::uint8_t> is_set{};
  std::vector<std::uint8_t> is_kept{};  // the value before the current entry is kept
  std::vector<GlobalInfo> info{};
};

// Layouts of records that only the library creates.
struct LibraryRecords {
  std::vector<std::unique_ptr<RecordLayout>> layouts{};
  std::vector<std::unique_ptr<std::vector<std::uint16_t>>> references{};
  const RecordLayout* error = nullptr;  // with one more slot than its type: the hidden fault
};

// The state of calls by the host between runs.
struct HostAccess {
  std::uint32_t calls = 0;             // prepared by native functions
  std::unique_ptr<Task> task{};        // for calls by the host; null before the first one
  Slot* window = nullptr;              // for their arguments
  std::optional<Diagnostic> error{};   // of the last call that failed
  bool all_are_set = false;            // all variables of the top level have values
  const void* ready_thread = nullptr;  // a thread that can call if its stack is in the range below
  std::uintptr_t ready_from = 0;
  std::uintptr_t ready_bytes = 0;
  std::optional<BegunCall> call{};           // set: a function runs instead of the program
  std::uint64_t started = 0;                 // count of tasks started by the host
  bool is_read = false;                      // a call that only reads, and leaves no trace
  std::atomic<const void*> thread{nullptr};  // that runs the program (this_thread); null: none
  std::uint64_t output_left = 0;             // bytes
  bool has_asked_to_stop = false;            // and the program is being stopped
  RunCounts aside{};                         // the counts of the run, while it does not run
  bool counts_apart = true;                  // current counts do not belong to the run
  std::function<void()> on_look{};           // for tests: called at every check for stop requests

  // Some global variables may have no value, so the next call has to check them.
  void require_values() {
    all_are_set = false;
    ready_thread = nullptr;
  }
};

struct VmState {
  VmState(Vm& vm, const CompiledProgram& program, const VmOptions& options);
  ~VmState();
  VmState(const VmState&) = delete;
  VmState& operator=(const VmState&) = delete;

  static constexpr std::uint32_t kHostCalls = 200;  // calls of the program inside calls of the host
  static constexpr std::uint32_t kScratch = 4;      // slots behind a frame for native calls

  Vm& vm;
  const VmOptions& options;
  Programs programs;
  Globals globals;
  Heap heap;
  StepMeter steps;
  KernelWork kernels;
  LibraryRecords records;
  SharedObjects shared;

  Task main;
  TaskTree tree{*this};
  std::unique_ptr<Task> condition_task;  // runs conditions; they never pause
  Task* running = nullptr;
  std::unique_ptr<Recordings> recordings;  // running ones; null before the first one
  std::unique_ptr<Waiting> pending;        // set by a native function that pauses
  std::shared_ptr<Fault> fault;            // the current failure
  bool is_leaving = false;                 // cancelled or out of steps: only finally blocks run
  Cancellations cancellations;
  Marks marks;
  std::unique_ptr<Scheduler> scheduler;  // of the run; null before it
  HostAccess host;

  // The program whose code the running task executes; without a task the newest one.
  [[nodiscard]] const CompiledProgram& code() const {
    const CompiledProgram* at = running->stack.top->callee->program;
    return at != nullptr ? *at : *programs.newest;
  }
  // The program has paused: the steps since a pause begin at 0 again, unless the program is being
  // stopped.
  void count_pause() {
    steps.settle();
    if (!is_leaving) steps.since_pause = 0;
  }
  // Must be called before a global variable changes.
  void keep_global(std::uint32_t number) {
    if (programs.before != nullptr && globals.is_kept[number] == 0) [[unlikely]]
      programs.before->keep(number);
  }
  void finish_call(bool done);
  // After the end of a run: allows calls of the program's functions with the full limits.
  void reopen();
  // Releases the global variables and all other objects that the run has left.
  void clear();
  [[nodiscard]] const RecordLayout& layout_of(const Type* record);
  // Pushes a host frame and the frame of the function on the running task. Returns false if calls
  // are nested too deep.
  [[nodiscard]] bool enter(std::uint32_t function, ClosureObj* closure);
  // Calls a function that may not pause, such as a condition, on a stack of its own.
  [[nodiscard]] bool evaluate(Task& owner, Obj* function, Slot& result);
  [[nodiscard]] bool evaluate(Task& owner, Obj* condition, bool& result);
  // Whether a stop request takes effect now: one that arrived since the last check, or in a replay
  // one that took effect here.
  [[nodiscard]] bool take_cancellation();
  void arm_cancellations(std::vector<Cancellation> wishes);
  // In a replay: sets the next check to the step of the next recorded stop request.
  void look_for_cancellation();
  // Removes all stop requests, before another run.
  void forget_cancellations();
  [[nodiscard]] Instant instant() const;
  // The text of an ASCII character: a literal or the one shared object; null if the heap is full.
  [[nodiscard]] Obj* character(unsigned char code);

 private:
  void make_error_layout();
};

}  // namespace armlet::lang

struct armlet::Vm::State final : lang::VmState {
  using VmState::VmState;
};
