#pragma once
// One task: its slots, its frames, and what it waits for.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "armlet/core/platform.hpp"
#include "armlet/core/random.hpp"
#include "armlet/interpreter/native.hpp"
#include "program/program.hpp"

namespace armlet::lang {

// A function as the loop needs it: one line of the cache, and all in one array by their numbers. A
// number may get another function while frames of the old one are alive, so frames refer to `own`,
// which stays as it is.
struct Callee {
  const Instr* code;
  const FunctionCode* function;  // null: the host
  const Slot* constants;
  const Slot* texts;                     // literals of its program
  const NativeFunction* const* natives;  // of its program
  const CompiledProgram* program;        // null: the host
  const Callee* own;                     // this one, where it does not move
  std::uint16_t registers;
  std::uint16_t references_begin;  // the first reference register
  std::uint16_t references;        // how many there are
  bool checks_result;              // it may hold elements that are not set
};

struct Frame {
  const Instr* pc;  // the next instruction, while something else runs
  Slot* base;       // register 0
  const Callee* callee;
  ClosureObj* closure;  // the running function value; not set for functions that are called by name

  [[nodiscard]] bool is_host() const { return callee->function == nullptr; }
  // The instruction that is being executed.
  [[nodiscard]] std::uint32_t at() const {
    return static_cast<std::uint32_t>(pc - callee->code) - 1;
  }
};

struct Fault;
struct Task;

inline constexpr std::size_t kNoRegion = static_cast<std::size_t>(-1);

// A `when` or `every` whose block has not ended.
struct Watch {
  Task* owner = nullptr;
  Span head{};               // where it is written
  std::size_t region = 0;    // of the owner
  Obj* condition = nullptr;  // null: `every`; owned
  Obj* body = nullptr;       // owned
  std::uint64_t order = 0;   // of arming; 0: no longer armed
  bool was_true = false;
  bool has_failed = false;  // an entry of a session that comes later leaves it at rest
  std::int64_t period_ns = 0;
  std::int64_t next_ns = 0;               // the next beat that has not been begun or skipped
  Task* running = nullptr;                // the body, while it runs
  std::shared_ptr<const void> host_data;  // of the owner when it was armed: see Vm::task_data
};

// A block that holds watches.
using Region = std::vector<std::unique_ptr<Watch>>;

// For frames of usual size at full depth, and a few very large ones.
constexpr std::size_t ample_slots(std::uint32_t call_depth) {
  return std::size_t{1024} * 1024 + std::size_t{call_depth} * 64;
}

// Bytes of its stack that every task begins with.
inline constexpr std::size_t kFirstBytes = 8192;

class Heap;

// Slots and frames of a task.
struct TaskStack {
  // call_depth  calls that may be nested.
  // slots       of all frames together, besides the one on top.
  TaskStack(std::uint32_t call_depth, std::size_t slots);

  Slot* slots_end;  // a frame that starts before it fits; what lies before it has been counted
  Frame* frames;    // frames[0] belongs to the host
  Frame* frames_end;
  Frame* top;
  Slot* slots_limit;  // how far slots_end and frames_end can move
  Frame* frames_limit;

  // Counts so much more of it against the limit of the heap that a frame can be put at `frame` with
  // its slots, `registers` of them, at `window`, which lie within the limits. False: the heap is
  // full.
  [[nodiscard]] bool grow(Heap& heap, const Frame* frame, Slot* window, std::size_t registers);
  // Gives back what grew.
  void shrink(Heap& heap);
  // Nothing is on it, and perhaps nothing will be for long.
  void rest();

 private:
  ReservedMemory slot_space_;
  ReservedMemory frame_space_;
  std::uint64_t charged_ = 0;  // bytes counted against the limit besides those at the beginning
};

// What a task is: vm/state/task_tree.hpp.
struct TaskOrigin {
  const hir::Function* function = nullptr;  // null: the program
  Task* parent = nullptr;                   // who started it
  Watch* watch = nullptr;                   // whose body it is
  std::string started_as{};                 // by the host: the variable with its function
  std::int64_t started_ns = 0;
  Obj* entry = nullptr;     // the closure that it runs; owned
  std::uint32_t depth = 0;  // of tasks that started tasks
  std::size_t place = 0;    // among the branches of its parent
};

// What a task has started.
struct TaskChildren {
  std::vector<Obj*> nursery{};            // closures of branches, before they begin; owned
  std::vector<Task*> branches{};          // of the `parallel` it waits for; null: ended
  std::size_t alive = 0;                  // branches that have not ended
  std::shared_ptr<Fault> branch_fault{};  // the first error among them
  bool joins = false;                     // it waits for its branches
  std::vector<Region> regions{};
  std::size_t ending = kNoRegion;  // it waits for the tasks of this region and those inside
};

// How many waits for a time or a motion it has begun at one instant.
struct WaitsAtOnce {
  std::int64_t at_ns = -1;
  int count = 0;
};

// A task waits while `waiting` is set.
struct Task {
  Task(std::uint32_t call_depth, std::size_t slots) : stack(call_depth, slots) {}

  TaskStack stack;

  std::unique_ptr<Waiting> waiting;
  Slot* result = nullptr;              // where the waiting call leaves its result
  Obj* condition = nullptr;            // armed: when it comes true, `waiting` is stopped; owned
  std::shared_ptr<Fault> interrupted;  // raised instead of going on when the wait is over
  std::uint64_t armed = 0;             // the condition's place in the order of arming; 0: none
  bool waits_until = false;  // `wait until`: the condition has to hold when the task goes on
  bool came_true = false;    // it did at this instant; it stays armed until the task's turn

  std::shared_ptr<const void> host_data;  // see Vm::task_data

  TaskOrigin origin;
  bool is_ready = false;  // has not begun
  bool has_ended = false;
  bool is_cancelled = false;  // how it ends is nobody's business
  Random random{0};
  std::uint64_t parallels = 0;  // how many it has begun

  TaskChildren children;
  WaitsAtOnce waits;

  [[nodiscard]] bool waits_for_its_tasks() const {
    return children.joins || children.ending != kNoRegion;
  }
};

}  // namespace armlet::lang
