#pragma once
// Which task runs when: the order at one instant (reference, section 12), and from one instant to
// the next.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "vm/state/interpret.hpp"

namespace armlet::lang {

// Runs a function as the main task. Its arguments are kept by the caller. It keeps how far it has
// come, nothing lies on the stack of the host, so a run can be left and gone on with.
class Scheduler {
 public:
  Scheduler(VmState& state, std::uint32_t function, std::vector<Slot> arguments = {})
      : state_(state), tree_(state.tree), function_(function), arguments_(std::move(arguments)) {}

  // Until the main task has ended or failed (state.fault), or the slice is over (kSliced): the
  // steps of the meter are used, or all has happened up to the virtual time `until_ns`.
  [[nodiscard]] Exit go_on(std::int64_t until_ns);

  // ---- a run that stays (VmOptions::stays)
  // The program has ended, and the run waits for its host.
  [[nodiscard]] bool is_resting() const { return is_resting_; }
  [[nodiscard]] bool is_at_rest() const { return is_resting_ && tree_.all().empty(); }
  // A task was started between two slices: it begins at this instant.
  void begin_started();
  // At rest: the run ends.
  void finish() { end(); }

 private:
  // What comes next. The rounds of one instant repeat until every task waits for a later one.
  enum class Stage : std::uint8_t {
    kBegin,    // nothing has happened
    kProgram,  // the program up to its first wait
    kInstant,  // what comes once at an instant
    kRound,    // conditions
    kTasks,    // tasks that may continue, one after the other
    kTime,     // on to the next instant
  };

  // kPaused: another stage comes.
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
  // What came true before others had their turn may not hold any more: false, and the task goes on
  // waiting.
  bool still_holds(Task& task);
  // The same for the body of a `when` that has not begun; it is dropped.
  bool still_triggered(Task& body);
  // What happened in one pass over the tasks.
  struct Pass {
    Exit exit = Exit::kPaused;  // of the program itself
    bool progress = false;
    bool changed = false;  // apart from tasks that began, or ended
    std::size_t next = 0;  // 0: the program
    bool inside = false;   // the slice ended while that task ran
  };
  // False: the slice is over.
  bool run_tasks();
  [[nodiscard]] bool has_turn(Task& task);
  Exit run(Task& task);
  Exit interpret_on(Task& task);
  Exit resume(Task& task);
  Exit begin(Task& task);
  Exit work(Task& task);

  // The next instant at which something can happen; kNever if there is none.
  [[nodiscard]] std::int64_t next_instant() const;
  [[nodiscard]] std::int64_t next_cancellation() const;
  // Nothing: the instant goes on, because something has failed.
  std::optional<std::int64_t> choose_instant();
  Exit pass_time();
  // False: the failure is set.
  bool finish(Waiting& waiting, Slot& result);
  // False: the host wants the program to stop.
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
  double last_ = 0.0;          // the double computed last by the task that the slice has cut
  std::int64_t until_ns_ = 0;  // of the slice
  std::int64_t resumed_ns_ = 0;
  Pass pass_;
  int rounds_ = 0;  // of this instant that changed something
  int quiet_ = 0;   // of this instant
  int failures_ = 0;
  std::optional<std::int64_t> target_ns_;  // the instant that time passes to
};

}  // namespace armlet::lang
