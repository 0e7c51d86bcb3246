// Tasks that the host starts, and calls that only read.

#include "armlet/interpreter/host/tasks.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "armlet/core/ample_stack.hpp"
#include "vm/failures/failures.hpp"
#include "vm/host/access.hpp"
#include "vm/host/aside.hpp"
#include "vm/host/no_trace.hpp"
#include "vm/host/values.hpp"
#include "vm/state/entries.hpp"
#include "vm/state/turn.hpp"
#include "vm/tasks/tasks.hpp"

namespace armlet {

namespace {

std::string named(std::string_view name) { return '`' + std::string(name) + '`'; }

const lang::hir::Variable& require_function(const lang::VmState& state, std::string_view name,
                                            std::size_t parameters = 0) {
  const lang::hir::Variable& variable = lang::require_global(state, name);
  if (variable.type->is(Kind::kFunction) && variable.type->parameters.size() == parameters)
    return variable;
  throw ArgumentError(named(name) + " is " + type_phrase(variable.type) + ", no function " +
                      (parameters == 0 ? "without parameters."
                                       : "of " + std::to_string(parameters) + " parameters."));
}

// Values in slots of a program, for the time of a call that reads.
class GivenSlots {
 public:
  GivenSlots(lang::VmState& state, const Type& function)
      : state_(state), types_(function.parameters) {}
  void give(std::span<const Value> values) {
    for (const Value& value : values) {
      slots_.push_back(
          lang::slot_of_value(state_, value, *types_[slots_.size()], "The argument of a function"));
    }
  }
  ~GivenSlots() {
    for (std::size_t i = 0; i < slots_.size(); ++i)
      if (types_[i]->is_reference()) state_.heap.release(slots_[i].o);
  }
  GivenSlots(const GivenSlots&) = delete;
  GivenSlots& operator=(const GivenSlots&) = delete;
  [[nodiscard]] std::span<const Slot> slots() const { return slots_; }

 private:
  lang::VmState& state_;
  std::span<const Type* const> types_;
  std::vector<Slot> slots_;
};

void require_staying(const lang::VmState& state) {
  if (!state.options.stays)
    throw ArgumentError("This run does not wait for its host (VmOptions::stays).");
}

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
  vm.result_ = {.status = Progress::kDone, .error = {}, .steps = state.host.aside.steps};
}

bool is_reading(Vm& vm) { return vm.state().host.is_read; }

Result<Value> read_function(Vm& vm, std::string_view name, std::span<const Value> arguments) {
  lang::VmState& state = vm.state();
  const lang::Turn turn(state);
  const lang::hir::Variable& variable = require_function(state, name, arguments.size());
  const Type& type = *variable.type->result;
  std::optional<Result<Value>> out;
  on_ample_stack([&] {
    const lang::NoTrace no_trace(state);
    const Supervised kernels(&state.kernels);
    Slot result{.i = 0};
    bool done = false;
    GivenSlots given(state, *variable.type);
    given.give(arguments);
    try {
      done = lang::evaluate_with(state, state.main, state.globals.values[variable.index].o,
                                 given.slots(), result);
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
