#pragma once
// Which task runs when: the order at one instant (reference, section 12), and from one instant to
// the next.

#include <cstdint>
#include <vector>

#include "vm/interpret.hpp"

namespace armlet::lang {

class Scheduler {
 public:
  explicit Scheduler(VmState& state) : state_(state), tasks_{&state.main} {}

  // Runs a function without arguments as the main task until it has ended or failed (state.fault).
  [[nodiscard]] Exit run(std::uint32_t function);

 private:
  // Everything that happens at the present instant. kPaused: all tasks wait for a later one.
  Exit run_instant();
  void evaluate_conditions();
  Exit resume(Task& task);
  // The next instant at which something can happen; kNever if there is none.
  [[nodiscard]] std::int64_t next_instant() const;
  Exit advance();
  void interrupt(Task& task);
  Exit abandon();
  void fail_everywhere(const char* code, const std::vector<std::string>& arguments,
                       std::string why);
  [[nodiscard]] std::string waited_for() const;

  VmState& state_;
  std::vector<Task*> tasks_;  // in the order of their creation
  std::int64_t resumed_ns_ = 0;
};

}  // namespace armlet::lang
