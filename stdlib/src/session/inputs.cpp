// Inputs of the host to a run, and how they are applied again in a replay.

#include <algorithm>
#include <utility>

#include "armlet/backend/event.hpp"
#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/globals.hpp"
#include "armlet/interpreter/host/instants.hpp"
#include "armlet/interpreter/host/stepping.hpp"
#include "armlet/interpreter/host/tasks.hpp"
#include "session/call_by_name.hpp"
#include "session/run.hpp"

namespace armlet {

Instant Session::instant() const { return run_->vm == nullptr ? Instant{} : instant_of(*run_->vm); }

void Session::set_signal(std::string_view name, SignalValue value) {
  require_idle("set a signal");
  if (const double* number = std::get_if<double>(&value); number != nullptr && *number != *number)
    throw ArgumentError("The signal \"" + std::string(name) +
                        "\" was given nan; any number will do, also an infinite one.");
  Input input{.at = {}, .what = SetSignal{std::string(name), value}};
  if (run_->host != nullptr) {
    run_->host->cell().signals().set(name, value);
    keep(std::move(input));
  } else {
    early_inputs_.push_back(std::move(input));
  }
}

void Session::set(std::string_view name, const Value& value) {
  require_run("set a variable");
  run_->vm->set(name, value);
  keep({.at = {}, .what = SetGlobal{std::string(name), value}});
}

Result<Value> Session::call(std::string_view name, const std::vector<Value>& arguments) {
  require_run("call a function");
  const CallFunction what{std::string(name), arguments};
  const Instant at = instant();
  Result<Value> result = call_function(*run_->vm, name, arguments, [&] {
    run_->journal->add({at, what});
  });
  note_progress();
  return result;
}

void Session::keep(Input input) {
  input.at = instant();
  run_->journal->add(std::move(input));
  note_progress();
}

void Session::note_progress() {
  Run& run = *run_;
  run.journal->note(instant(), cancellations(*run.vm));
  if (!run.journal->has_left()) return;
  const std::optional<LoggedEntry> left = run.journal->left_run();
  std::vector<Entry> former = run.entries;
  former[run.current()].logged = *left;
  run.entries.erase(run.entries.begin() + static_cast<std::ptrdiff_t>(run.current()) + 1,
                    run.entries.end());
  run.journal->forget_later();
  cancel_at(*run.vm, {});
  if (!is_silent_) keep_run(log_of(former));
}

void Session::apply(const Input& input) {
  const Input taken = input;  // a call may change the list
  run_->journal->pass();
  try {
    static_cast<void>(act(taken.what));
  } catch (const ArgumentError&) {
    // Another text may not have this name; the input is then skipped.
  }
}

std::optional<Error> Session::act(const Action& action) {
  std::optional<Error> refused;
  Vm& vm = *run_->vm;
  Cell& cell = run_->host->cell();
  std::visit(Overload{[&](const SetSignal& each) { cell.signals().set(each.name, each.value); },
                      [&](const SetGlobal& each) { vm.set(each.name, each.value); },
                      [&](const CallFunction& each) {
                        static_cast<void>(call_function(vm, each.name, each.arguments, [] {}));
                      },
                      [&](const PressButton& each) { refused = start_task(vm, each.name); },
                      [&](const MoveJoints& each) {
                        const std::optional<int> robot = cell.find_robot(each.robot);
                        if (!robot) throw ArgumentError("There is no such robot.");
                        cell.set_joints(*robot, Eigen::Map<const Eigen::VectorXd>(
                                                    each.q.data(), std::ssize(each.q)));
                      }},
             action);
  return refused;
}

void Session::apply_due_inputs() {
  for (const Input* next = run_->journal->next();
       next != nullptr && instant().has_reached(next->at); next = run_->journal->next())
    apply(*next);
}

// Whether the input came after the start of the run; only signals may come before it. A program
// that takes neither time nor steps has the same instant before and after it.
static bool comes_after_begin(const Input& input) {
  return !std::holds_alternative<SetSignal>(input.what);
}

static bool is_used(const Budget& left) { return left.steps == 0 || left.statements == 0; }

void Session::run_along(const Budget& budget) {
  if (run_->journal->next() == nullptr) {
    run_slice(budget);
    return;
  }
  const std::uint64_t steps = instant().steps;
  const std::uint64_t statements = statements_begun(*run_->vm);
  const auto left = [&] {
    Budget rest = budget;
    const auto spend = [](std::uint64_t& part, std::uint64_t used) {
      if (part != Budget::kNoLimit) part -= std::min(part, used);
    };
    spend(rest.steps, instant().steps - steps);
    spend(rest.statements, statements_begun(*run_->vm) - statements);
    return rest;
  };
  for (const Input* next = run_->journal->next(); next != nullptr; next = run_->journal->next()) {
    const Instant at = next->at;
    if (budget.until_ns && *budget.until_ns < at.t_ns) break;
    if (!instant().has_reached(at) || (comes_after_begin(*next) && !run_->has_run)) {
      run_to(at, left);
      if (is_at_breakpoint(*run_->vm)) return;
    }
    if (run_->result.status != Progress::kPaused || is_used(left())) return;
    // Another text may take other steps: then only the time counts.
    if (instant().t_ns >= at.t_ns) apply(*next);
  }
  if (!is_used(left())) run_slice(left());
}

// Stops one nanosecond earlier first: the steps may have been taken long before that time.
void Session::run_to(const Instant& at, const std::function<Budget()>& left) {
  Budget budget = left();
  if (instant().t_ns < at.t_ns) {
    budget.until_ns = at.t_ns - 1;
    if (run_slice(budget) != Progress::kPaused || is_at_breakpoint(*run_->vm)) return;
    budget = left();
    if (is_used(budget)) return;
  }
  budget.until_ns = at.t_ns;
  const std::uint64_t steps = instant().steps;
  if (at.steps > steps) budget.steps = std::min(budget.steps, at.steps - steps);
  run_slice(budget);
}

}  // namespace armlet
