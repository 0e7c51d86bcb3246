// What the host does to a run, and the run once more with all that it did.

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "armlet/backend/fan_out.hpp"
#include "armlet/core/error.hpp"
#include "armlet/core/format.hpp"
#include "armlet/interpreter/host/globals.hpp"
#include "armlet/interpreter/host/instants.hpp"
#include "armlet/interpreter/host/program_function.hpp"
#include "armlet/interpreter/host/tasks.hpp"
#include "armlet/stdlib/session.hpp"
#include "replay/former.hpp"
#include "replay/journal.hpp"

namespace armlet {
namespace {

// Calls a function of the program by name, with values. `on_call` comes when it is known that the
// values fit.
Result<Value> call_function(Vm& vm, const std::string& name, const std::vector<Value>& arguments,
                            const std::function<void()>& on_call) {
  if (arguments.size() > ReadyFunction::kMostParameters) {
    throw ArgumentError(fmt::format("`{}` is called with {} values; hosts pass at most {}.", name,
                                    arguments.size(), ReadyFunction::kMostParameters));
  }
  const std::vector<ValueKind> takes(arguments.size());
  Result<ReadyFunction> found = ReadyFunction::find(vm, name, takes, {ValueKind::Form::kNothing});
  const bool gives = !found.ok();
  if (gives) found = ReadyFunction::find(vm, name, takes, {});
  const ReadyFunction& function = found.value();
  ReadyFunction::Call call(function);
  std::vector<Slot> slots(arguments.size());
  Slot result{.i = 0};
  for (std::size_t i = 0; i < arguments.size(); ++i)
    static_cast<void>(call.pass(i, arguments[i], slots[i]));
  on_call();
  if (!call.run(slots, result).done) return Error{"failed", vm.error()->message};
  return gives ? call.take<Value>(result) : Value();
}

bool is_same(const RunLimits& a, const RunLimits& b) {
  return a.steps == b.steps && a.heap_bytes == b.heap_bytes && a.call_depth == b.call_depth &&
         a.output_bytes == b.output_bytes && a.time_ns == b.time_ns;
}

// What the log of another session differs in; empty: in nothing that matters to a run.
std::string difference(const SessionLog& ours, const SessionLog& theirs) {
  const auto named = [](const std::string& name) {
    return name.empty() ? std::string("none") : '"' + name + '"';
  };
  if (ours.robot != theirs.robot) {
    return fmt::format("the robot of the log is {}, that of the session {}", named(theirs.robot),
                       named(ours.robot));
  }
  if (ours.planners != theirs.planners) return "the log was made with other planners of the host";
  if (ours.world != theirs.world || ours.default_world != theirs.default_world)
    return "the log was made in another world";
  if (ours.laboratory != theirs.laboratory)
    return theirs.laboratory ? "the log is of a laboratory" : "the session is that of a laboratory";
  if (!is_same(ours.limits, theirs.limits)) return "the log was made with other limits of runs";
  return {};
}

}  // namespace

void Session::require_idle(std::string_view what) const {
  if (!is_running_.load()) return;
  throw ArgumentError(
      fmt::format("A session cannot {} while its program runs; use another one.", what));
}

void Session::require_run(std::string_view what) const {
  require_idle(what);
  if (vm_ == nullptr)
    throw ArgumentError(fmt::format("A session cannot {} before its first run.", what));
}

Instant Session::instant() const { return vm_ == nullptr ? Instant{} : instant_of(*vm_); }

// ---- what the host does ---------------------------------------------------------------------

void Session::set_signal(std::string_view name, SignalValue value) {
  require_idle("set a signal");
  Input input{.at = {}, .what = SetSignal{std::string(name), value}};
  if (is_under_way_ || (is_entry_ && host_ != nullptr)) {
    host_->cell().signals().set(name, value);
    keep(std::move(input));
  } else {
    early_inputs_.push_back(std::move(input));
  }
}

void Session::set(std::string_view name, const Value& value) {
  require_run("set a variable");
  vm_->set(name, value);
  keep({.at = {}, .what = SetGlobal{std::string(name), value}});
}

Result<Value> Session::call(std::string_view name, const std::vector<Value>& arguments) {
  require_run("call a function");
  const CallFunction what{std::string(name), arguments};
  const Instant at = instant();
  Result<Value> result =
      call_function(*vm_, what.name, arguments, [&] { journal_->add({.at = at, .what = what}); });
  note_progress();
  return result;
}

void Session::keep(Input input) {
  input.at = instant();
  journal_->add(std::move(input));
  note_progress();
}

// ---- the log --------------------------------------------------------------------------------

LoggedEntry Session::known_run() const {
  if (is_entry_) {
    throw ArgumentError(
        "A session of entries has no log of a single run: undo() and redo() go back and forth.");
  }
  if (journal_ != nullptr) return journal_->entry();
  if (repeated_) return *repeated_;
  const Source& source = sources()[0];
  return {.name = source.name(), .text = std::string(source.text()), .imports = imports_};
}

SessionLog Session::log_of(LoggedEntry entry) const {
  SessionLog log;
  if (options_.robot != nullptr) log.robot = options_.robot->name();
  for (const NamedPlanner& each : options_.planners) log.planners.push_back(each.name);
  log.world = options_.world;
  log.default_world = options_.default_world;
  log.limits = options_.limits;
  log.open = options_.open;
  log.laboratory = options_.laboratory;
  log.entry = std::move(entry);
  return log;
}

SessionLog Session::log() const {
  require_idle("give its log");
  return log_of(known_run());
}

ModuleLoader Session::load_imports() {
  imports_.clear();
  if (!repeated_ && !options_.load) return {};
  return [this](const std::string& path, const std::string& from) {
    LoggedImport import{path, from, {}};
    if (repeated_) {
      for (const LoggedImport& each : repeated_->imports) {
        if (each.path == path && each.from == from) import.given = each.given;
      }
    } else {
      import.given = options_.load(path, from);
    }
    imports_.push_back(import);
    return import.given;
  };
}

void Session::begin_journal() {
  const bool repeats = repeated_.has_value();
  LoggedEntry entry = is_entry_ ? LoggedEntry{} : known_run();
  if (!repeats) entry = {.name = entry.name, .text = entry.text, .imports = entry.imports};
  repeated_.reset();
  journal_ = std::make_unique<Journal>(std::move(entry));
  journal_->set_silent(is_silent_);
  journal_->set_keeps_files(options_.keeps_files);
  if (repeats) return;
  for (Input& each : early_inputs_) journal_->expect(std::move(each));
  early_inputs_.clear();
}

void Session::note_progress() {
  journal_->note(instant(), cancellations(*vm_));
  std::optional<LoggedEntry> left = journal_->left_run();
  if (!left) return;
  cancel_at(*vm_, {});
  if (!is_silent_ && !is_entry_) runs_.push_back(log_of(*std::move(left)));
}

// ---- a run once more ------------------------------------------------------------------------

void Session::apply(const Input& input) {
  const Input taken = input;  // a call may change the list
  journal_->pass();
  try {
    static_cast<void>(act(taken.what));
  } catch (const ArgumentError&) {
    // Another text may have no such name: there is nothing to set or to call.
  }
}

std::optional<Error> Session::act(const Action& action) {
  std::optional<Error> refused;
  Cell& cell = host_->cell();
  std::visit(Overload{[&](const SetSignal& each) { cell.signals().set(each.name, each.value); },
                      [&](const SetGlobal& each) { vm_->set(each.name, each.value); },
                      [&](const CallFunction& each) {
                        static_cast<void>(call_function(*vm_, each.name, each.arguments, [] {}));
                      },
                      [&](const PressButton& each) { refused = start_task(*vm_, each.name); },
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
  for (const Input* next = journal_->next(); next != nullptr && instant().has_reached(next->at);
       next = journal_->next())
    apply(*next);
}

static bool is_used(const Budget& left) { return left.steps == 0 || left.statements == 0; }

void Session::run_along(const Budget& budget) {
  const std::uint64_t steps = instant().steps;
  const std::uint64_t statements = statements_begun(*vm_);
  const auto left = [&] {
    Budget rest = budget;
    const auto spend = [](std::uint64_t& part, std::uint64_t used) {
      if (part != Budget::kNoLimit) part -= std::min(part, used);
    };
    spend(rest.steps, instant().steps - steps);
    spend(rest.statements, statements_begun(*vm_) - statements);
    return rest;
  };
  for (const Input* next = journal_->next(); next != nullptr; next = journal_->next()) {
    const Instant at = next->at;
    if (budget.until_ns && *budget.until_ns < at.t_ns) break;
    if (!instant().has_reached(at)) {
      run_to(at, left);
      if (is_at_breakpoint(*vm_)) return;
    }
    if (result_.status != Progress::kPaused || is_used(left())) return;
    // Another text may take other steps: then the time alone counts.
    if (instant().t_ns >= at.t_ns) apply(*next);
  }
  if (!is_used(left())) run_slice(left());
}

// The nanosecond before comes first: the steps may have been taken long before the time.
void Session::run_to(const Instant& at, const std::function<Budget()>& left) {
  Budget budget = left();
  if (instant().t_ns < at.t_ns) {
    budget.until_ns = at.t_ns - 1;
    if (run_slice(budget) != Progress::kPaused || is_at_breakpoint(*vm_)) return;
    budget = left();
    if (is_used(budget)) return;
  }
  budget.until_ns = at.t_ns;
  const std::uint64_t steps = instant().steps;
  if (at.steps > steps) budget.steps = std::min(budget.steps, at.steps - steps);
  run_slice(budget);
}

bool Session::replay(const SessionLog& log) {
  require_idle("replay a log");
  if (const std::string why = difference(log_of({}), log); !why.empty())
    throw ArgumentError("This log cannot be replayed here: " + why + '.');
  give_up();
  journal_.reset();
  repeated_ = log.entry;
  if (compile_program(log.entry.text, log.entry.name)) return true;
  repeated_.reset();
  return false;
}

// Everything up to a time that the run has left behind; otherwise the very place to which it has
// come, which may lie within an instant.
void Session::run_again_to(std::int64_t t_ns, const Instant& end) {
  if (t_ns < end.t_ns) return run_along({.until_ns = t_ns});
  if (t_ns > 0) run_along({.until_ns = t_ns - 1});
  if (result_.status != Progress::kPaused) return;
  const std::uint64_t steps = instant().steps;
  if (end.steps > steps) {
    run_along({.until_ns = t_ns, .steps = end.steps - steps});
  } else if (instant().t_ns < t_ns) {
    run_along({.until_ns = t_ns});
  }
  apply_due_inputs();
}

void Session::require_time(std::int64_t t_ns, const Instant& end) {
  if (t_ns >= 0 && t_ns <= end.t_ns) return;
  throw ArgumentError(fmt::format("The run has come to t = {} s; there is no t = {} s to go to.",
                                  format_number(to_seconds(end.t_ns), 9),
                                  format_number(to_seconds(t_ns), 9)));
}

bool Session::go_to(std::int64_t t_ns) {
  require_idle("go to another time");
  LoggedEntry run = known_run();
  require_time(t_ns, run.end);
  const Instant end = run.end;
  return take_again(std::move(run), [this, t_ns, end] { run_again_to(t_ns, end); });
}

Session::Former Session::put_aside() {
  Former former{std::move(journal_),
                std::move(host_),
                std::move(fan_out_),
                std::move(vm_),
                result_,
                std::exchange(is_under_way_, false),
                repeated_};
  return former;
}

void Session::bring_back(Former former) {
  vm_ = std::move(former.vm);  // first: a Vm goes before its host
  journal_ = std::move(former.journal);
  host_ = std::move(former.host);
  fan_out_ = std::move(former.fan_out);
  result_ = std::move(former.result);
  is_under_way_ = former.is_under_way;
  repeated_ = std::move(former.repeated);
  is_silent_ = false;
  cancelled_.store(false);
}

// While the run goes to its time, the one before is put aside.
bool Session::take_again(LoggedEntry run, const std::function<void()>& go) {
  const std::vector<Cancellation> cancelled = run.cancelled;
  Former former = put_aside();
  try {
    repeated_ = std::move(run);
    is_silent_ = true;
    go_on(go);
  } catch (...) {
    bring_back(std::move(former));
    throw;
  }
  if (journal_->entry().cancelled != cancelled) {
    bring_back(std::move(former));
    return false;
  }
  is_silent_ = false;
  journal_->set_silent(false);
  fan_out_->set_muted(false);
  if (!breakpoints_.empty()) armlet::set_breakpoints(*vm_, breakpoints_);
  return true;
}

}  // namespace armlet
