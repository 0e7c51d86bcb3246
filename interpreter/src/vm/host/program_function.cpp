// Calls of functions of the program by the host that owns the Vm.

#include "armlet/interpreter/host/program_function.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "armlet/core/ample_stack.hpp"
#include "vm/host/access.hpp"
#include "vm/host/frames.hpp"
#include "vm/host/values.hpp"
#include "vm/state/turn.hpp"
#include "vocabulary/typed_signature.hpp"

namespace armlet {

namespace {

using Outcome = ReadyFunction::Outcome;

// The signature that the host requests, with its C++ types.
struct Asked {
  std::span<const ValueKind> takes;
  const ValueKind& gives;

  [[nodiscard]] std::string text() const {
    std::string out = lang::stored_name(gives) + '(';
    for (std::size_t i = 0; i < takes.size(); ++i)
      out += (i == 0 ? "" : ", ") + lang::stored_name(takes[i]);
    return out + ')';
  }
};

// The reason why a function does not have the requested signature; empty if it has.
std::string misfit(const lang::hir::Function& function, const Asked& asked) {
  const std::size_t count = function.parameters.size();
  if (count != asked.takes.size())
    return "it has " + std::to_string(count) + (count == 1 ? " parameter" : " parameters") +
           ", and is given " + std::to_string(asked.takes.size());
  for (std::size_t i = 0; i < count; ++i) {
    const lang::hir::Variable& parameter = *function.parameters[i];
    if (!lang::stands_for(*parameter.type, asked.takes[i]))
      return '`' + std::string(parameter.name) + "` is " + type_phrase(parameter.type) +
             ", where C++ passes " + lang::stored_name(asked.takes[i]);
  }
  const Type* result = function.result;
  if (lang::stands_for(*result, asked.gives)) return {};
  return "it gives " + (result->is(Kind::kVoid) ? std::string("nothing") : type_phrase(result)) +
         ", where C++ wants " + lang::stored_name(asked.gives);
}

const lang::hir::Function& require_function(const lang::VmState& state, std::string_view name,
                                            const Asked& asked) {
  const auto functions = lang::require_functions(state, name);
  for (const lang::hir::Function* function : functions) {
    if (misfit(*function, asked).empty()) return *function;
  }
  const lang::hir::Function& first = *functions.front();
  throw ArgumentError('`' + lang::signature_of(first) + "` of the program cannot be called as `" +
                      asked.text() + "`: " + misfit(first, asked) + '.');
}

// Calls by the host run on a task of their own, so they are possible while a task of the program is
// paused.
void make_task(lang::VmState& state) {
  std::unique_ptr<lang::Task>& task = state.host.task;
  if (task != nullptr) return;
  const std::uint32_t depth = state.options.limits.call_depth;
  task = std::make_unique<lang::Task>(depth, lang::ample_slots(depth));
  task->origin.parent = &state.main;
  state.host.window = lang::window_above(*task->stack.frames);
  lang::push_host(*task, task->stack.frames, state.host.window);
}

[[gnu::cold, gnu::noinline]] void take_data(const lang::VmState& state, lang::Task& task) {
  task.host_data = state.main.host_data;
}

// In the lifetime of a Running the task of the host is the running one. Only one such call can
// exist at a time, since it needs exclusive use of the Vm.
class Running {
 public:
  [[gnu::always_inline]] Running(lang::VmState& state, lang::Task& task)
      : state_(state), before_(state.running), kernels_(&state.kernels) {
    if (task.host_data != state.main.host_data) [[unlikely]]
      take_data(state, task);
    state.running = &task;
    state.host.calls = 1;
    state.steps.begin_call();
  }
  [[gnu::always_inline]] ~Running() {
    state_.host.calls = 0;
    state_.running = before_;
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

 private:
  lang::VmState& state_;
  lang::Task* before_;
  Supervised kernels_;
};

// A stop request that arrived before the call is kept for the paused run. Without a paused run it
// is dropped, because it arrived too late.
[[gnu::cold, gnu::noinline]] void keep_for_paused_run(lang::VmState& state) {
  if (state.vm.result().status == Progress::kPaused) state.vm.cancel();
}

// Runs the loop with the arguments in their window, where the result is stored as well. At its end
// the top frame is that of the host.
[[gnu::always_inline]] inline lang::Left enter(lang::VmState& state, const lang::Callee& callee) {
  lang::Task& task = *state.host.task;
  Slot* window = state.host.window;
  const Running running(state, task);
  if (state.vm.take_cancellation()) [[unlikely]]
    keep_for_paused_run(state);
  if (!lang::count_step(state)) [[unlikely]]
    return {lang::Exit::kFailed};
  lang::Frame* frame = task.stack.frames + 2;
  frame->base = window;
  asm volatile("" : "+r"(window));  // two stores are faster than combining both values first
  frame->callee = &callee;
  lang::clear_references(*frame);
  return lang::enter_function(state, task, frame, window, callee.code);
}

[[gnu::cold, gnu::noinline]] Outcome fail(lang::VmState& state) {
  lang::keep_failure(state);
  return {false};
}

[[gnu::always_inline]] inline Outcome run_here(lang::VmState& state, const lang::Callee& callee) {
  const lang::Left left = enter(state, callee);
  if (left.exit == lang::Exit::kDone) [[likely]]
    return {true, left.result};
  return fail(state);
}

// Runs the call on a larger stack if the current one is too small.
[[gnu::cold, gnu::noinline]] Outcome run_elsewhere(lang::VmState& state,
                                                   const lang::Callee& callee) {
  Outcome outcome{false};
  on_ample_stack([&] { outcome = run_here(state, callee); });
  return outcome;
}

// The slow start of a call: checks that all global variables have values and that the stack is
// large enough. The result is valid for a thread, a part of its stack, and a program.
[[gnu::cold, gnu::noinline]] Outcome run_unready(lang::VmState& state, const lang::Callee& callee,
                                                 std::uintptr_t here) {
  lang::require_values_of_globals(state);
  const std::size_t left = stack_left();
  if (left < kAmpleStack) return run_elsewhere(state, callee);
  state.host.ready_thread = lang::this_thread();
  state.host.ready_from = here - (left - kAmpleStack);
  state.host.ready_bytes = left - kAmpleStack + 1;
  return run_here(state, callee);
}

[[gnu::always_inline]] inline Outcome run_in_turn(lang::VmState& state,
                                                  const lang::Callee& callee) {
  const lang::HostAccess& host = state.host;
  char mark;
  const auto here = reinterpret_cast<std::uintptr_t>(&mark);
  if (host.ready_thread == lang::this_thread() && here - host.ready_from < host.ready_bytes)
      [[likely]]
    return run_here(state, callee);
  return run_unready(state, callee, here);
}

// Passes the result to the caller. A result that the caller cannot own, or with unset elements, is
// released and reported.
Outcome given(lang::VmState& state, const lang::Callee& callee, Outcome outcome, Slot& result) {
  result = *state.host.window;
  if (!outcome.done || !callee.checks_result) return outcome;
  const Running running(state, *state.host.task);
  return lang::check_given(state, callee, result) ? outcome : fail(state);
}

}  // namespace

bool lang::run_for_host(VmState& state, const Callee& callee, std::span<const Slot> arguments,
                        Slot& result) {
  make_task(state);
  std::ranges::copy(arguments, state.host.window);
  return given(state, callee, run_elsewhere(state, callee), result).done;
}

namespace {

[[noreturn, gnu::cold]] void refuse_gone() {
  throw ArgumentError(
      "This function is gone: the entry of the session that declares it has failed.");
}

[[gnu::always_inline]] inline const lang::Callee& callee_of(const lang::VmState& state,
                                                            std::uint32_t function) {
  const lang::Callee* callee = state.programs.callees[function].own;
  if (callee == nullptr) [[unlikely]]
    refuse_gone();
  return *callee;
}

const lang::hir::Function& declared(const lang::VmState& state, std::uint32_t function) {
  return *callee_of(state, function).function->function;
}

}  // namespace

ReadyFunction::ReadyFunction(Vm& vm, std::uint32_t function)
    : vm_(&vm), state_(&vm.state()), function_(function) {}

Result<ReadyFunction> ReadyFunction::find(Vm& vm, std::string_view name,
                                          std::span<const ValueKind> takes,
                                          const ValueKind& gives) {
  lang::VmState& state = vm.state();
  try {
    const lang::Turn turn(state);
    const lang::hir::Function& function = require_function(state, name, {takes, gives});
    make_task(state);
    return ReadyFunction(vm, function.index);
  } catch (const ArgumentError& error) {
    return Error{"function", error.what()};
  }
}

Outcome ReadyFunction::run(std::span<const Slot> arguments, Slot& result) const {
  lang::VmState& state = *state_;
  const lang::Turn turn(state);
  std::ranges::copy(arguments, state.host.window);
  const Outcome outcome = run_in_turn(state, callee_of(state, function_));
  result = *state.host.window;
  return outcome;
}

// A window always has room for three arguments, even if the function has fewer.
Outcome ReadyFunction::run(Slot first, Slot second, Slot third, Slot& result) const {
  lang::VmState& state = *state_;
  const lang::Turn turn(state);
  Slot* window = state.host.window;
  window[0] = first;
  window[1] = second;
  window[2] = third;
  const Outcome outcome = run_in_turn(state, callee_of(state, function_));
  result = *window;
  return outcome;
}

Outcome ReadyFunction::run_reals(double first, double second, double third) const {
  lang::VmState& state = *state_;
  const lang::Turn turn(state);
  Slot* window = state.host.window;
  window[0].d = first;
  window[1].d = second;
  window[2].d = third;
  return run_in_turn(state, callee_of(state, function_));
}

Outcome ReadyFunction::run_reals(double only) const {
  lang::VmState& state = *state_;
  const lang::Turn turn(state);
  state.host.window->d = only;
  return run_in_turn(state, callee_of(state, function_));
}

Outcome ReadyFunction::run_reals() const {
  lang::VmState& state = *state_;
  const lang::Turn turn(state);
  return run_in_turn(state, callee_of(state, function_));
}

namespace {

[[noreturn]] void refuse_argument(const lang::hir::Function& function, std::size_t parameter,
                                  const std::string& why) {
  throw ArgumentError('`' + std::string(function.parameters[parameter]->name) + "` of `" +
                      std::string(function.name) + "` " + why + '.');
}

}  // namespace

void ReadyFunction::refuse_undefined(std::size_t parameter) const {
  lang::VmState& state = *state_;
  const lang::Turn turn(state);
  const lang::hir::Function& function = declared(state, function_);
  refuse_argument(
      function, parameter,
      "takes " + type_phrase(function.parameters[parameter]->type) + lang::kUndefinedNumber);
}

// ---- in slices

void ReadyFunction::begin(std::span<const Value> arguments) const {
  lang::VmState& state = vm_->state();
  const lang::Turn turn(state);
  lang::require_values_of_globals(state);
  const auto& parameters = declared(state, function_).parameters;
  if (arguments.size() != parameters.size()) {
    throw ArgumentError("This function has " + std::to_string(parameters.size()) +
                        " parameters, and is given " + std::to_string(arguments.size()) + '.');
  }
  lang::BegunCall call{function_, {}};
  std::vector<Slot> slots;
  try {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const lang::hir::Variable& parameter = *parameters[i];
      slots.push_back(lang::slot_of_value(state, arguments[i], *parameter.type,
                                          '`' + std::string(parameter.name) + '`'));
      if (parameter.type->is_reference()) call.kept.push_back(slots.back().o);
    }
    vm_->begin_call(function_, std::move(slots));
  } catch (...) {
    for (Obj* object : call.kept) state.heap.release(object);
    throw;
  }
  state.host.call = std::move(call);
}

// ---- calls with objects

ReadyFunction::Call::Call(const ReadyFunction& function, Counts counts)
    : function_(function), counts_(counts) {
  lang::begin_turn(function.vm().state());
}

ReadyFunction::Call::~Call() {
  lang::VmState& state = function_.vm().state();
  for (std::size_t i = 0; i < count_; ++i) state.heap.release(kept_[i]);
  lang::end_turn(state);
}

Outcome ReadyFunction::Call::run(std::span<const Slot> arguments, Slot& result) {
  lang::VmState& state = function_.vm().state();
  std::ranges::copy(arguments, state.host.window);
  const lang::Callee& callee = callee_of(state, function_.function_);
  std::optional<lang::CallOfRun> counting;
  if (counts_ == Counts::kWithRun) counting.emplace(state);
  return given(state, callee, run_in_turn(state, callee), result);
}

void ReadyFunction::Call::keep(Obj* object) { kept_[count_++] = object; }

void ReadyFunction::Call::fail() { lang::keep_failure(function_.vm().state()); }

void ReadyFunction::Call::require_text(std::size_t parameter, std::string_view text) const {
  if (const auto at = lang::broken_byte(text))
    refuse_argument(declared(function_.vm().state(), function_.function_), parameter,
                    lang::broken_text(*at));
}

void ReadyFunction::Call::pass_value(std::size_t parameter, const Value& value, Slot& slot) {
  const lang::hir::Variable& variable =
      *declared(function_.vm().state(), function_.function_).parameters[parameter];
  slot = lang::slot_of_value(function_.vm().state(), value, *variable.type,
                             '`' + std::string(variable.name) + '`');
  if (variable.type->is_reference()) keep(slot.o);
}

Value ReadyFunction::Call::take_value(Slot result) {
  const lang::hir::Function& function = declared(function_.vm().state(), function_.function_);
  if (function.result->is_reference()) keep(result.o);
  return lang::value_in(result, *function.result,
                        "The result of `" + std::string(function.name) + '`');
}

}  // namespace armlet
