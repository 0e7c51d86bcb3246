// Tasks that the host starts, and functions that it reads.

#include "armlet/interpreter/host/tasks.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "armlet/core/ample_stack.hpp"
#include "vm/entries.hpp"
#include "vm/failures/failures.hpp"
#include "vm/host/access.hpp"
#include "vm/host/values.hpp"
#include "vm/tasks/tasks.hpp"
#include "vm/turn.hpp"

namespace armlet {

namespace {

std::string named(std::string_view name) { return '`' + std::string(name) + '`'; }

const lang::hir::Variable& require_function(const lang::VmState& state, std::string_view name) {
  const lang::hir::Variable& variable = lang::require_global(state, name);
  if (variable.type->is(Kind::kFunction) && variable.type->parameters.empty()) return variable;
  throw ArgumentError(named(name) + " is " + type_phrase(variable.type) +
                      ", no function without parameters.");
}

void require_staying(const lang::VmState& state) {
  if (!state.options.stays)
    throw ArgumentError("This run does not wait for its host (VmOptions::stays).");
}

// What a read must leave as it was.
class NoTrace {
 public:
  explicit NoTrace(lang::VmState& state)
      : state_(state),
        kept_(std::exchange(state.globals.is_kept,
                            std::vector<std::uint8_t>(state.globals.is_kept.size(), 0))),
        entry_(std::exchange(state.programs.before, std::make_unique<lang::Before>(state))),
        steps_(state.steps),
        marks_(state.marks),
        due_(std::exchange(state.cancellations.due, {})),
        noticed_(state.cancellations.noticed.size()),
        fault_(std::move(state.fault)),
        is_leaving_(std::exchange(state.is_leaving, false)) {
    state.host.is_read = true;
    state.marks.breakpoints.clear();
    state.marks.pause_at = lang::StepMeter::kEndless;
    state.steps.look_at = lang::StepMeter::kEndless;
    state.steps.paused();
  }
  ~NoTrace() {
    state_.host.is_read = false;
    state_.cancellations.noticed.resize(noticed_);
    state_.cancellations.due = std::move(due_);
    state_.steps = steps_;
    state_.marks = std::move(marks_);
    state_.fault = std::move(fault_);
    state_.is_leaving = is_leaving_;
    state_.programs.before->restore();
    state_.programs.before = std::move(entry_);
    state_.globals.is_kept = std::move(kept_);
  }
  NoTrace(const NoTrace&) = delete;
  NoTrace& operator=(const NoTrace&) = delete;

 private:
  lang::VmState& state_;
  std::vector<std::uint8_t> kept_;       // of the entry under way, if there is one
  std::unique_ptr<lang::Before> entry_;  // likewise
  lang::StepMeter steps_;
  lang::Marks marks_;
  std::vector<Cancellation> due_;
  std::size_t noticed_;
  lang::FaultPtr fault_;
  bool is_leaving_;
};

}  // namespace

std::optional<Error> start_task(Vm& vm, std::string_view name) {
  lang::VmState& state = vm.state();
  const lang::Turn turn(state);
  require_staying(state);
  if (vm.result().status != Progress::kPaused || state.scheduler == nullptr)
    throw ArgumentError("A task can be started only while the run goes on.");
  const lang::hir::Variable& variable = require_function(state, name);
  if (state.tree.create_started(state.globals.values[variable.index].o, name) == nullptr) {
    const Error error{"tasks", state.fault->diagnostic.message};
    lang::keep_failure(state);
    return error;
  }
  state.scheduler->begin_started();
  return std::nullopt;
}

bool is_at_rest(Vm& vm) {
  const lang::VmState& state = vm.state();
  return state.scheduler != nullptr && state.scheduler->is_at_rest();
}

void finish(Vm& vm) {
  lang::VmState& state = vm.state();
  const lang::Turn turn(state);
  if (!is_at_rest(vm))
    throw ArgumentError("A run is finished when its program and all tasks have ended.");
  state.scheduler->finish();
  vm.result_ = {.status = Progress::kDone, .error = {}, .steps = state.steps.total};
}

Result<Value> read_function(Vm& vm, std::string_view name) {
  lang::VmState& state = vm.state();
  const lang::Turn turn(state);
  const lang::hir::Variable& variable = require_function(state, name);
  const Type& type = *variable.type->result;
  std::optional<Result<Value>> out;
  on_ample_stack([&] {
    const NoTrace no_trace(state);
    const Supervised kernels(&state.kernels);
    Slot result{.i = 0};
    bool done = false;
    try {
      done = state.evaluate(state.main, state.globals.values[variable.index].o, result);
    } catch (...) {
      lang::raise_thrown(state, state.main);
    }
    if (done) {
      try {
        out = lang::value_in(result, type, "The result of " + named(name));
      } catch (const ArgumentError& error) {
        out = Error{"failed", error.what()};
      }
      if (type.is_reference()) state.heap.release(result.o);
    } else {
      out = Error{"failed", state.fault->diagnostic.message};
      lang::keep_failure(state);
    }
  });
  return *std::move(out);
}

}  // namespace armlet
