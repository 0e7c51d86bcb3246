#pragma once
// The tasks of a run besides the program itself: who started whom, what each watches, how they end.
//
// Nothing outlives what started it: branches end before their `parallel`, the bodies of `when` and
// `every` before the block around these.

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

// Something that is looked at again and again: what a task waits for, or a watch.
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
  // In the order of their creation. Those that have ended stay until `sweep`.
  [[nodiscard]] const std::vector<std::unique_ptr<Task>>& all() const { return tasks_; }
  // A task that will begin to run the closure. Null: the failure is set.
  [[nodiscard]] Task* create(Task& parent, Obj* closure);
  // The same for a function that the host starts, which a variable holds.
  [[nodiscard]] Task* create_started(Obj* closure, std::string_view variable);
  // Those of them that run are brought to an end.
  void cancel_started();
  // The running task is done, or failed; whoever waits for it is told.
  void end(Task& task, std::shared_ptr<Fault> fault);
  // The fault is raised in a waiting task once what it does has come to a stop.
  void interrupt(Task& task, std::shared_ptr<Fault> fault);
  void cancel(Task& task, Reach reach);
  // What `task` has started ends on the spot, without its finally blocks.
  void abandon(Task& task);
  void sweep();
  void clear();

  // ---- conditions and watches: watches.cpp
  // In the order of arming.
  [[nodiscard]] const std::map<std::uint64_t, Armed>& armed() const { return armed_; }
  void arm(Task& task);
  void disarm(Task& task);
  // A new watch of the innermost watched block, armed. A null condition: `every`.
  Watch& watch(Task& owner, Obj* condition, Obj* body);
  // Starts the body. False: the failure is set.
  [[nodiscard]] bool start(Watch& watch);
  // Raises a failure of a watch in the block that it belongs to.
  void fail_block(Watch& watch, const std::shared_ptr<Fault>& fault);
  // Starts the bodies whose beat has come; false if there are none.
  bool start_beats();
  // The watches of the regions from `from` on stop watching.
  void stop_watching(Task& owner, std::size_t from);
  void cancel_bodies(Task& owner, std::size_t from, Reach reach);
  [[nodiscard]] static bool has_bodies(const Task& owner, std::size_t from);
  void close_regions(Task& owner, std::size_t from);
  // The watches of the program's own block, between the entries of a session: they rest, and are
  // armed again in their order. One that has failed is not.
  void wake_watches();
  // Those from `first` on were armed by an entry that failed.
  void forget_watches(std::size_t first);
  // Whatever the program has started ends on the spot, but for those watches.
  void rest();
  // Advice about beats that were skipped, in the order of the text.
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
  std::vector<std::unique_ptr<Task>> spare_;  // stacks to be used again
  std::size_t alive_ = 0;
  std::map<std::uint64_t, Armed> armed_;
  std::uint64_t last_order_ = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Skips> skips_;  // by source and place
};

// Whether the first is to be raised rather than the second.
[[nodiscard]] bool outranks(const Fault& a, const Fault& b);

}  // namespace armlet::lang
