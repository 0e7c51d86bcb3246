#pragma once
// One task: its slots, its frames, and the operation that it waits for.

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

// A function as the instruction loop uses it, one cache line each, in an array by number. A number
// may get another function while frames of the old one exist, so frames refer to `own`, which does
// not change.
struct Callee {
  const Instr* code;
  const FunctionCode* function;  // null: a host frame
  const Slot* constants;
  const Slot* texts;                     // of the literals of its program
  const NativeFunction* const* natives;  // of its program
  const CompiledProgram* program;        // null: a host frame
  const Callee* own;                     // the copy of this one that is never moved
  std::uint16_t registers;
  std::uint16_t references_begin;  // the first reference register
  std::uint16_t references;        // how many there are
  bool checks_result;              // may return a list whose elements have no value
};

struct Frame {
  const Instr* pc;  // the next instruction, unless the frame is executed
  Slot* base;       // register 0
  const Callee* callee;
  ClosureObj* closure;  // of a function value; not set for functions called by name

  [[nodiscard]] bool is_host() const { return callee->function == nullptr; }
  // The position of the current instruction.
  [[nodiscard]] std::uint32_t at() const {
    return static_cast<std::uint32_t>(pc - callee->code) - 1;
  }
};

struct Fault;
struct Task;

inline constexpr std::size_t kNoRegion = static_cast<std::size_t>(-1);

// A `when` or `every` statement whose block has not ended.
struct Watch {
  Task* owner = nullptr;
  Span head{};               // the span of its head
  std::size_t region = 0;    // index in the regions of the owner
  Obj* condition = nullptr;  // null: `every`; owned
  Obj* body = nullptr;       // owned
  std::uint64_t order = 0;   // of arming; 0: no longer armed
  bool was_true = false;
  bool has_failed = false;  // a later entry of a session does not activate it again
  std::int64_t period_ns = 0;
  std::int64_t next_ns = 0;               // the next beat that is neither executed nor skipped
  Task* running = nullptr;                // the body, while it runs
  std::shared_ptr<const void> host_data;  // of the owner when it was armed: see Vm::task_data
};

// The watches of one block.
using Region = std::vector<std::unique_ptr<Watch>>;

// Enough slots for frames of usual size at the largest depth of calls, and for a few very large
// ones.
constexpr std::size_t ample_slots(std::uint32_t call_depth) {
  return std::size_t{1024} * 1024 + std::size_t{call_depth} * 64;
}

// The size in bytes of the stack that each task has from the start.
inline constexpr std::size_t kFirstBytes = 8192;

class Heap;

// The memory for the slots and frames of a task.
struct TaskStack {
  // call_depth  the largest depth of nested calls.
  // slots       the largest count of slots of all frames, apart from the top one.
  TaskStack(std::uint32_t call_depth, std::size_t slots);

  Slot* slots_end;  // a frame that starts before it has room, counted for the limit of the heap
  Frame* frames;    // frames[0] belongs to the host
  Frame* frames_end;
  Frame* top;
  Slot* slots_limit;  // slots_end and frames_end grow up to these limits
  Frame* frames_limit;

  // Grows the stack for a frame at `frame` with `registers` slots at `window`, which must be below
  // slots_limit and frames_limit. The bytes count for the limit of the heap. Returns false if the
  // heap is full.
  [[nodiscard]] bool grow(Heap& heap, const Frame* frame, Slot* window, std::size_t registers);
  // Releases the memory that grow() added.
  void shrink(Heap& heap);
  // Releases memory of an empty stack that may stay empty for a long time.
  void rest();

 private:
  ReservedMemory slot_space_;
  ReservedMemory frame_space_;
  std::uint64_t charged_ = 0;  // bytes from grow(), counted for the limit of the heap
};

// The cause and the code of a task: see vm/state/task_tree.hpp.
struct TaskOrigin {
  const hir::Function* function = nullptr;  // null: the program
  Task* parent = nullptr;                   // that started it
  Watch* watch = nullptr;                   // whose body it runs
  std::string started_as{};  // the variable with its function, if the host started it
  std::int64_t started_ns = 0;
  Obj* entry = nullptr;     // the closure that it runs; owned
  std::uint32_t depth = 0;  // nesting of tasks that start tasks
  std::size_t place = 0;    // index among the branches of its parent
};

// The tasks and watches that a task has started.
struct TaskChildren {
  std::vector<Obj*> nursery{};            // closures of branches, before they begin; owned
  std::vector<Task*> branches{};          // of the `parallel` it waits for; null: ended
  std::size_t alive = 0;                  // branches that have not ended
  std::shared_ptr<Fault> branch_fault{};  // the first error among them
  bool joins = false;                     // it waits for its branches
  std::vector<Region> regions{};
  std::size_t ending = kNoRegion;  // it waits for the tasks of this region and of inner ones
};

// The count of waits for times or motions that a task began at one instant.
struct WaitsAtOnce {
  std::int64_t at_ns = -1;
  int count = 0;
};

// A task waits while `waiting` is set.
struct Task {
  Task(std::uint32_t call_depth, std::size_t slots) : stack(call_depth, slots) {}

  TaskStack stack;

  std::unique_ptr<Waiting> waiting;
  Slot* result = nullptr;              // the destination of the result of the wait
  Obj* condition = nullptr;            // armed: ends the wait when it becomes true; owned
  std::shared_ptr<Fault> interrupted;  // raised when the wait is over
  std::uint64_t armed = 0;             // number in the order of arming; 0: not armed
  bool waits_until = false;  // `wait until`: the condition has to hold when the task continues
  bool came_true = false;    // at this instant; stays armed until the task continues

  std::shared_ptr<const void> host_data;  // see Vm::task_data

  TaskOrigin origin;
  bool is_ready = false;  // to begin
  bool has_ended = false;
  bool is_cancelled = false;  // its failure is not reported
  Random random{0};
  std::uint64_t parallels = 0;  // count of those that it has begun

  TaskChildren children;
  WaitsAtOnce waits;

  [[nodiscard]] bool waits_for_its_tasks() const {
    return children.joins || children.ending != kNoRegion;
  }
};

}  // namespace armlet::lang
