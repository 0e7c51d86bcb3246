#pragma once
// The tasks of a run besides the program itself: which task started which, the watches of each, and
// their ends.
//
// Each task ends before the statement that started it: branches end before their `parallel`, the
// bodies of `when` and `every` before the block around these.

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "vm/state/task.hpp"

namespace armlet::lang {

struct VmState;
struct Fault;
enum class Reach : std::uint8_t;

// A condition that is evaluated at each instant: that of a waiting task, or of a watch.
struct Armed {
  Task* task = nullptr;
  Watch* watch = nullptr;
};

class TaskTree {
 public:
  static constexpr std::size_t kMostTasks = 10'000;
  static constexpr std::uint32_t kDeepest = 1000;

  explicit TaskTree(VmState& state) : state_(state) {}

  // ---- tasks: task_tree.cpp
  // The tasks in the order of their creation. Those that have ended stay in the list until `sweep`.
  [[nodiscard]] const std::vector<std::unique_ptr<Task>>& all() const { return tasks_; }
  // Creates a task that will run the closure. Returns null, with the failure set, if it cannot.
  [[nodiscard]] Task* create(Task& parent, Obj* closure);
  // Creates a task that will run the function in a variable, started by the host.
  [[nodiscard]] Task* create_started(Obj* closure, std::string_view variable);
  // Cancels the running tasks that the host started.
  void cancel_started();
  // Ends the running task, with a failure or without, and informs the task that waits for it.
  void end(Task& task, std::shared_ptr<Fault> fault);
  // Raises the fault in a waiting task as soon as its operation has stopped.
  void interrupt(Task& task, std::shared_ptr<Fault> fault);
  void cancel(Task& task, Reach reach);
  // Ends all tasks that `task` has started at once, without their finally blocks.
  void abandon(Task& task);
  void sweep();
  void clear();

  // ---- conditions and watches: watches.cpp
  // The armed conditions and watches, in the order of arming.
  [[nodiscard]] const std::map<std::uint64_t, Armed>& armed() const { return armed_; }
  void arm(Task& task);
  void disarm(Task& task);
  // Adds an active watch to the innermost watched block. condition: null for `every`.
  Watch& watch(Task& owner, Obj* condition, Obj* body);
  // Starts the body of a watch. Returns false if that fails; the failure is set.
  [[nodiscard]] bool start(Watch& watch);
  // Raises the failure of a watch in the block with the watch.
  void fail_block(Watch& watch, const std::shared_ptr<Fault>& fault);
  // Starts the bodies of `every` whose beat is now. Returns false if there are none.
  bool start_beats();
  // Disarms the watches of the regions from `from` on.
  void stop_watching(Task& owner, std::size_t from);
  void cancel_bodies(Task& owner, std::size_t from, Reach reach);
  [[nodiscard]] static bool has_bodies(const Task& owner, std::size_t from);
  void close_regions(Task& owner, std::size_t from);
  // Activates the watches at the top level of the program again, in their order, before the next
  // entry of a session. Watches that have failed stay disarmed.
  void wake_watches();
  // Removes the watches from number `first` on, which an entry that failed had armed.
  void forget_watches(std::size_t first);
  // Between two entries: disarms the watches at the top level, and ends all tasks of the program at
  // once.
  void rest();
  // Reports skipped beats as advice, in the order of the text.
  void report_skipped();

 private:
  struct Skips {
    Span head;
    std::int64_t count = 0;
  };
  void end_started(Task& task, std::shared_ptr<Fault> fault);
  void cancel_branches(Task& task, Reach reach);
  void fail_parallel(Task& parent, const std::shared_ptr<Fault>& fault);
  void skip_beats(Watch& watch);
  void disarm(Watch& watch);
  void kill(Task& task);
  void end_at_once(Task& task);

  VmState& state_;
  std::vector<std::unique_ptr<Task>> tasks_;
  std::vector<std::unique_ptr<Task>> spare_;  // to be used again
  std::size_t alive_ = 0;
  std::map<std::uint64_t, Armed> armed_;
  std::uint64_t last_order_ = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Skips> skips_;  // by source and byte
};

// Whether fault `a` has priority over fault `b`.
[[nodiscard]] bool outranks(const Fault& a, const Fault& b);

}  // namespace armlet::lang
