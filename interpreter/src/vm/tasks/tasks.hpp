#pragma once
// The scheduler: the order of tasks at one instant (reference, section 12), and the passage of time
// from one instant to the next.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "vm/state/interpret.hpp"

namespace armlet::lang {

// Runs a function as the main task, with arguments that the caller keeps. Its state is in members
// and not on the stack of the host, so a run can be left and continued later.
class Scheduler {
 public:
  Scheduler(VmState& state, std::uint32_t function, std::vector<Slot> arguments = {})
      : state_(state), tree_(state.tree), function_(function), arguments_(std::move(arguments)) {}

  // Runs until the main task has ended or failed (state.fault), or until the end of the slice
  // (kSliced): the steps of the meter are used, or everything up to the virtual time `until_ns` is
  // done.
  [[nodiscard]] Exit go_on(std::int64_t until_ns);

  // ---- a run that stays (VmOptions::stays)
  // Whether the program has ended and the run waits for calls of its host.
  [[nodiscard]] bool is_resting() const { return is_resting_; }
  [[nodiscard]] bool is_at_rest() const { return is_resting_ && tree_.all().empty(); }
  // A task was started between two slices, and begins at this instant.
  void begin_started();
  // Ends a run whose program has ended.
  void finish() { end(); }

 private:
  // The next action. The rounds of an instant repeat until every task waits for a later instant.
  enum class Stage : std::uint8_t {
    kBegin,    // nothing yet
    kProgram,  // run the program up to its first wait
    kInstant,  // actions that happen once at an instant
    kRound,    // evaluate conditions
    kTasks,    // run tasks that may continue, one after the other
    kTime,     // pass on to the next instant
  };

  // Does the action of the stage. kPaused: another stage follows.
  Exit do_stage();
  Exit begin_program();
  Exit run_program();
  void begin_instant();
  void begin_round();
  Exit finish_round();
  Exit finished(Exit exit);
  void end();

  void evaluate_conditions();
  void evaluate(Task& task);
  void evaluate(Watch& watch);
  // Whether a condition that became true still holds after other tasks have run. If not, the task
  // continues to wait.
  bool still_holds(Task& task);
  // Whether the condition of a `when` still holds before its body begins; if not, the body is
  // dropped.
  bool still_triggered(Task& body);
  // The results of one pass over the tasks.
  struct Pass {
    Exit exit = Exit::kPaused;  // of the program itself
    bool progress = false;
    bool changed = false;  // by more than beginnings and ends of tasks
    std::size_t next = 0;  // index of the next task; 0: the program
    bool inside = false;   // the slice ended while that task ran
  };
  // Runs all tasks that may continue. Returns false if the slice is over.
  bool run_tasks();
  [[nodiscard]] bool has_turn(Task& task);
  Exit run(Task& task);
  Exit interpret_on(Task& task);
  Exit resume(Task& task);
  Exit begin(Task& task);
  Exit work(Task& task);

  // The next instant at which a task can continue; kNever if there is none.
  [[nodiscard]] std::int64_t next_instant() const;
  [[nodiscard]] std::int64_t next_cancellation() const;
  // The instant to pass to. Empty: a failure was raised, so the current instant continues.
  std::optional<std::int64_t> choose_instant();
  Exit pass_time();
  // Completes a wait. Returns false, with the failure set, if it failed.
  bool finish(Waiting& waiting, Slot& result);
  // Lets time pass. Returns false if the host requests a stop.
  bool advance_to(std::int64_t t_ns);
  Exit stop();
  Exit abandon();
  void fail_everywhere(const Headline& headline, std::string why);
  [[nodiscard]] std::string waited_for() const;

  VmState& state_;
  TaskTree& tree_;
  const std::uint32_t function_;
  const std::vector<Slot> arguments_;
  Stage stage_ = Stage::kBegin;
  bool is_resting_ = false;
  double last_ = 0.0;          // the accumulator of the task that the end of the slice interrupted
  std::int64_t until_ns_ = 0;  // of the slice
  std::int64_t resumed_ns_ = 0;
  Pass pass_;
  int rounds_ = 0;  // at this instant, with changes
  int quiet_ = 0;   // at this instant, without changes
  int failures_ = 0;
  std::optional<std::int64_t> target_ns_;  // the instant that time passes to
};

}  // namespace armlet::lang
