#pragma once
// Everything a running Vm consists of, and the operations on it that several parts share.

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

// How far a failure goes; what goes further outranks the other.
enum class Reach : std::uint8_t {
  kHandlers,  // the nearest catch or finally
  kFinally,   // only through finally blocks: the program is being stopped
  kNothing,   // straight out
};

struct Fault {
  Diagnostic diagnostic;
  std::string kind;  // as e.kind shows it
  Reach reach = Reach::kHandlers;
  bool cancelled = false;
  bool is_leaving = false;         // the whole program ends with it
  std::size_t region = kNoRegion;  // kFinally: only as far as this watched block of its task
  std::shared_ptr<const FailureDetail> detail{};
};
using FaultPtr = std::shared_ptr<Fault>;

// Counts calls and backward jumps. The loop only counts `left` down; every chunk the limit and the
// wish to cancel are looked at.
struct StepMeter {
  static constexpr std::uint64_t kChunk = 4096;

  std::int64_t left = 0;               // of the running chunk; below 0 it is used up
  std::int64_t chunk = 0;              // size of the running chunk
  std::uint64_t total = 0;             // before the running chunk
  std::uint64_t since_pause = 0;       // likewise
  std::uint64_t limit = 0;             // between two pauses
  std::uint64_t slice_end = kEndless;  // the total at which the run returns to the host
  std::uint64_t look_at = kEndless;    // the total at which the wish to cancel is looked at

  static constexpr std::uint64_t kEndless = std::numeric_limits<std::uint64_t>::max();

  // With the running chunk.
  [[nodiscard]] std::uint64_t so_far() const {
    return total + static_cast<std::uint64_t>(chunk - left);
  }
  // Books the running chunk.
  void settle() {
    const auto done = static_cast<std::uint64_t>(chunk - left);
    total += done;
    since_pause += done;
    chunk = left = 0;
  }
  // Starts a new chunk; false if the limit is reached.
  [[nodiscard]] bool refill();
  // Whether the host has to be asked before the next step; books the running chunk.
  [[nodiscard]] bool slice_is_over() {
    settle();
    return total >= slice_end;
  }
  void begin_slice(std::uint64_t steps) {
    settle();
    slice_end = steps < kEndless - total ? total + steps : kEndless;
  }
  // Counts what takes as long as so many steps. The limits are looked at with the next step.
  void book(std::uint64_t steps) {
    settle();
    total += steps;
    since_pause += steps;
  }
  // A call by the host may take as many steps as the program between two pauses: what the running
  // chunk has done is booked when it is settled.
  void begin_call() { since_pause = static_cast<std::uint64_t>(left - chunk); }
};

class Recordings;
class Scheduler;

// Statements that have begun, in programs with markers, and where the run pauses before one.
struct Marks {
  std::uint64_t begun = 0;
  std::uint64_t pause_at = StepMeter::kEndless;  // so many have begun
  std::vector<SourceLine> breakpoints;           // sorted
  bool is_at_breakpoint = false;                 // the run has paused at one
  const Task* paused = nullptr;                  // before its next instruction, a MARK
};

// Counts what kernels of the library do as steps.
class KernelWork final : public Supervisor {
 public:
  explicit KernelWork(Vm& vm) : vm_(vm) {}
  [[nodiscard]] bool go_on(std::uint64_t operations) override;
  // Operations that have not made a whole step.
  [[nodiscard]] std::uint64_t rest() const { return rest_; }
  void set_rest(std::uint64_t rest) { rest_ = rest; }

 private:
  Vm& vm_;
  std::uint64_t rest_ = 0;
};

// Tells threads apart for less than asking the system.
[[nodiscard]] inline const void* this_thread() { return &armlet::detail::present_supervisor; }

// Stands for a row that a loop may look for, but that its list does not have (ROW).
struct MissingRow : ListObj {
  std::int64_t index;
  std::uint64_t rows;  // that there are
  const Instr* at;     // where it was looked for
};

// The entry of a map that was found last.
struct LastEntry {
  const MapEntry* entries = nullptr;  // of the map; it may be gone
  std::uint32_t number = 0;
};

// Objects that are made once, or are kept out of the heap.
struct SharedObjects {
  static constexpr std::size_t kMissingRows = 8;  // of one loop

  using Ascii = std::array<Obj*, 128>;
  static constexpr Ascii kNoAscii{};

  // Texts of one character, each made when it is first needed; and the room for them.
  const Ascii* ascii = &kNoAscii;
  std::unique_ptr<Ascii> made_ascii{};
  LastEntry last_entry = {};
  MissingRow missing_rows[kMissingRows] = {};  // only loops that call nothing have any
  std::unordered_map<const Instr*, std::uint32_t> large_copies{};  // by place: how many there were
};

// A function that runs as a program does, with the objects among its arguments.
struct BegunCall {
  std::uint32_t function;
  std::vector<Obj*> kept;
};

// Programs that have begun here.
struct Programs {
  const CompiledProgram* newest;
  std::vector<Callee> callees{};                     // by number of the function
  std::unique_ptr<Before> before{};                  // an entry is under way
  std::vector<std::unique_ptr<LoadedCode>> units{};  // whose code may still run
};

// Variables of the top level, by their numbers.
struct Globals {
  std::vector<Slot> values{};
  std::vector<std::uint8_t> is_set{};
  std::vector<std::uint8_t> is_kept{};  // as it was before the entry under way
  std::vector<GlobalInfo> info{};
};

// Layouts of records that only the library makes.
struct LibraryRecords {
  std::vector<std::unique_ptr<RecordLayout>> layouts{};
  std::vector<std::unique_ptr<std::vector<std::uint16_t>>> references{};
  const RecordLayout* error = nullptr;  // one slot more than the type says: the hidden fault
};

// What the host that owns the Vm asks of it between its runs, and what it gives and takes.
struct HostAccess {
  std::uint32_t calls = 0;             // that native functions have prepared
  std::unique_ptr<Task> task{};        // on which its calls run; null before the first one
  Slot* window = nullptr;              // where their arguments go
  std::optional<Diagnostic> error{};   // of the last call that failed
  bool all_are_set = false;            // all variables of the top level have values
  const void* ready_thread = nullptr;  // that can call if its stack is here or above
  std::uintptr_t ready_from = 0;
  std::uintptr_t ready_bytes = 0;
  std::optional<BegunCall> call{};           // a function runs instead of the program
  std::uint64_t started = 0;                 // tasks that the host has started
  bool is_read = false;                      // and no trace may stay
  std::atomic<const void*> thread{nullptr};  // that runs the program (this_thread); null: none does
  std::uint64_t output_left = 0;             // bytes
  bool has_asked_to_stop = false;            // for which the program is being stopped
  RunCounts aside{};                         // what the run has counted, while it does not run
  bool counts_apart = true;                  // what is counted now is not of the run
  std::function<void()> on_look{};  // for tests: called at every look at the wish to cancel

  // Before the next call: there are variables of the top level that may have none.
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
  static constexpr std::uint32_t kScratch = 4;  // slots behind a frame that native calls may use

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
  std::unique_ptr<Recordings> recordings;  // under way; null before the first one
  std::unique_ptr<Waiting> pending;        // left by a native function that pauses
  std::shared_ptr<Fault> fault;            // the failure under way
  bool is_leaving = false;                 // cancelled or out of steps: only finally blocks run
  Cancellations cancellations;
  Marks marks;
  std::unique_ptr<Scheduler> scheduler;  // of the run; null before it
  HostAccess host;

  // The program whose code the running task is at; the newest one where there is none.
  [[nodiscard]] const CompiledProgram& code() const {
    const CompiledProgram* at = running->stack.top->callee->program;
    return at != nullptr ? *at : *programs.newest;
  }
  // The program has paused: it has its steps anew, unless it is being stopped.
  void count_pause() {
    steps.settle();
    if (!is_leaving) steps.since_pause = 0;
  }
  // To be called before a variable changes.
  void keep_global(std::uint32_t number) {
    if (programs.before != nullptr && globals.is_kept[number] == 0) [[unlikely]]
      programs.before->keep(number);
  }
  void finish_call(bool done);
  // After the end of a run: functions of the program can be called with all that the limits allow.
  void reopen();
  // Releases the program's variables and whatever else the run left.
  void clear();
  [[nodiscard]] const RecordLayout& layout_of(const Type* record);
  // Puts a host frame and the function's frame on the running task. False: calls are nested too
  // deep.
  [[nodiscard]] bool enter(std::uint32_t function, ClosureObj* closure);
  // Evaluates what may not pause, such as a condition of a task, on a stack of its own.
  [[nodiscard]] bool evaluate(Task& owner, Obj* function, Slot& result);
  [[nodiscard]] bool evaluate(Task& owner, Obj* condition, bool& result);
  // Whether somebody asked to cancel since the last look, or did so here in the run that this one
  // repeats.
  [[nodiscard]] bool take_cancellation();
  void arm_cancellations(std::vector<Cancellation> wishes);
  // The next one that is due is looked at exactly where it is.
  void look_for_cancellation();
  // Another run begins, which has noticed none.
  void forget_cancellations();
  [[nodiscard]] Instant instant() const;
  // The literal, or the one shared text of an ASCII character; null: the heap is full.
  [[nodiscard]] Obj* character(unsigned char code);

 private:
  void make_error_layout();
};

}  // namespace armlet::lang

struct armlet::Vm::State final : lang::VmState {
  using VmState::VmState;
};
