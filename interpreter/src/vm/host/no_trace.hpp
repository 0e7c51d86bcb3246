#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "vm/state/entries.hpp"
#include "vm/state/state.hpp"

namespace armlet::lang {

// The state that a call that only reads must not change; restored at the end of the call.
class NoTrace {
 public:
  explicit NoTrace(VmState& state)
      : state_(state),
        kept_(std::exchange(state.globals.is_kept,
                            std::vector<std::uint8_t>(state.globals.is_kept.size(), 0))),
        entry_(std::exchange(state.programs.before, std::make_unique<Before>(state))),
        steps_(state.steps),
        marks_(state.marks),
        fault_(std::move(state.fault)) {
    state.host.is_read = true;
    state.marks.breakpoints.clear();
    state.marks.pause_at = StepMeter::kEndless;
    state.count_pause();
  }
  ~NoTrace() {
    state_.programs.before->restore();
    state_.programs.before = std::move(entry_);
    state_.globals.is_kept = std::move(kept_);
    state_.host.is_read = false;
    state_.steps = steps_;
    state_.marks = std::move(marks_);
    state_.fault = std::move(fault_);
  }
  NoTrace(const NoTrace&) = delete;
  NoTrace& operator=(const NoTrace&) = delete;

 private:
  VmState& state_;
  std::vector<std::uint8_t> kept_;  // of the current entry, if there is one
  std::unique_ptr<Before> entry_;   // likewise
  StepMeter steps_;
  Marks marks_;
  FaultPtr fault_;
};

}  // namespace armlet::lang
