#pragma once
// Which task runs when: the order at one instant (reference, section 12), and from one instant to
// the next.

#include <cstdint>
#include <string>
#include <vector>

#include "vm/instructions/interpret.hpp"

namespace armlet::lang {

class Scheduler {
 public:
  explicit Scheduler(VmState& state) : state_(state), tree_(state.tree) {}

  // Runs a function without arguments as the main task until it has ended or failed (state.fault).
  [[nodiscard]] Exit run(std::uint32_t function);

 private:
  // Everything that happens at the present instant. kPaused: all tasks wait for a later one.
  Exit run_instant();
  Exit finished(Exit exit);
  void evaluate_conditions();
  void evaluate(Task& task);
  void evaluate(Watch& watch);
  // What happened in one pass over the tasks.
  struct Pass {
    Exit exit = Exit::kPaused;  // of the program itself
    bool progress = false;
    bool changed = false;  // apart from tasks that began, or ended
  };
  Pass run_tasks();
  Exit resume(Task& task);
  Exit begin(Task& task);
  // The next instant at which something can happen; kNever if there is none.
  [[nodiscard]] std::int64_t next_instant() const;
  Exit advance();
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
  std::int64_t resumed_ns_ = 0;
};

}  // namespace armlet::lang
