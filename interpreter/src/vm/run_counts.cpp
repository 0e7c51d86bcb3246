#include "vm/state/run_counts.hpp"

#include "vm/state/state.hpp"

namespace armlet::lang {

namespace {

void count_on(VmState& state) {
  state.steps.settle();
  state.steps.total = state.host.aside.steps;
  state.kernels.set_rest(state.host.aside.work);
  state.marks.begun = state.host.aside.statements;
  state.host.counts_apart = false;
}

void put_aside(VmState& state) {
  state.steps.settle();
  state.host.aside.steps = state.steps.total;
  state.host.aside.work = state.kernels.rest();
  state.host.aside.statements = state.marks.begun;
  state.host.counts_apart = true;
}

}  // namespace

CountOfRun::CountOfRun(VmState& state) : state_(state) {
  count_on(state);
  state.steps.since_pause = state.host.aside.since_pause;
  state.steps.limit = state.host.aside.limit;
  state.is_leaving = state.host.aside.is_leaving;
  state.host.has_asked_to_stop = state.host.aside.is_stopped;
}

CountOfRun::~CountOfRun() {
  put_aside(state_);
  state_.host.aside.since_pause = state_.steps.since_pause;
  state_.host.aside.limit = state_.steps.limit;
  state_.host.aside.is_leaving = state_.is_leaving;
  state_.host.aside.is_stopped = state_.host.has_asked_to_stop;
  state_.steps.limit = state_.options.limits.steps;
  state_.is_leaving = state_.host.has_asked_to_stop = false;
}

CallOfRun::CallOfRun(VmState& state) : state_(state) { count_on(state); }
CallOfRun::~CallOfRun() { put_aside(state_); }

}  // namespace armlet::lang
