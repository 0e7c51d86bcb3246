#pragma once
// Tasks on a virtual clock: the order at one instant, from one instant to the next, and how tasks
// end (language reference, section 12, and decision 7).
//
// A task is a thread of the processor, so that it can wait in the middle of whatever it does. Only
// one thread runs at a time: the scheduler gives control to a task, and gets it back when that
// waits or has ended.

#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <semaphore>
#include <vector>

#include "value.hpp"

namespace armlet::oracle {

// What is raised in a task that waits. The less its level, the further it goes.
struct Raised {
  static constexpr std::size_t kWholeTask = 0;  // cancelled: finally blocks see it, nobody else
  // 1 and more: as far as the watched block with this number, counted from the outermost of its
  // task; from there on it is an error like any other.
  static constexpr std::size_t kError = std::numeric_limits<std::size_t>::max();

  std::size_t level = kError;
  std::optional<Failure> failure;  // none: cancelled
};

class Tasks {
 public:
  using Body = std::function<void()>;
  using Condition = std::function<bool()>;

  Tasks();
  ~Tasks();
  Tasks(const Tasks&) = delete;
  Tasks& operator=(const Tasks&) = delete;

  // Runs a program to its end, with all tasks it starts. What it throws is thrown again.
  void run(Body program);
  [[nodiscard]] std::int64_t now_ns() const { return now_; }

  // ---- what a running task asks for. All may throw a Failure, or a Raised that goes further.
  void sleep(std::int64_t ns);
  // False: the time was up first.
  [[nodiscard]] bool wait_until(Condition condition, std::optional<std::int64_t> timeout_ns);
  void parallel(std::vector<Body> branches);
  // A block that watches, until it is closed; gives its level.
  [[nodiscard]] std::size_t open_block();
  void watch(Condition condition, Body body);
  void watch(std::int64_t period_ns, Body body);
  // Its watches end. Bodies that still run are waited for; after a failure they are cancelled.
  void close_block(bool after_failure);

 private:
  struct Task;
  struct Watch;
  struct Armed {
    Task* task;    // that waits until its condition comes true, or
    Watch* watch;  // a `when` or `every`
  };

  // ---- the order of things
  void at_one_instant();
  void look_at_conditions();
  [[nodiscard]] bool continue_tasks();  // false: nobody could
  [[nodiscard]] bool begin_beats();
  [[nodiscard]] std::int64_t next_instant() const;
  [[nodiscard]] bool may_continue(const Task& task) const;
  // any  set to true if something happens that lets others go on.
  [[nodiscard]] bool has_turn(Task& task, bool& any);
  void drop(Task& task);  // a body that has not begun
  void give_turn(Task& task);
  void give_back();  // the running task waits until it has control again

  // ---- how tasks begin and end
  Task& create(Body body, Task* parent, Watch* watch);
  void ended(Task& task);
  void interrupt(Task& task, Raised raised);
  void cancel(Task& task);
  void raise_in_block(const Watch& watch, const Failure& failure);
  void stop_watching(Task& owner, std::size_t from);
  void cancel_bodies(const Task& owner, std::size_t from);
  void skip_beats(Watch& watch) const;

  std::vector<std::unique_ptr<Task>> tasks_;  // in the order of their creation
  std::map<std::uint64_t, Armed> armed_;      // in the order of arming
  std::uint64_t last_order_ = 0;
  std::int64_t now_ = 0;
  Task* running_ = nullptr;
  std::binary_semaphore scheduler_{0};  // it has control
  bool abandoned_ = false;              // all threads come to an end, doing nothing more
  std::exception_ptr broken_;           // the oracle itself failed
};

}  // namespace armlet::oracle
