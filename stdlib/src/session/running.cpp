// How the entries of a session run: their starts, slices and ends.

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/instants.hpp"
#include "armlet/interpreter/host/stepping.hpp"
#include "armlet/interpreter/host/tasks.hpp"
#include "moves/motion_torques.hpp"
#include "session/call_by_name.hpp"
#include "session/run.hpp"

namespace armlet {
namespace {

// The variable is "scaraLab.pickIt".
PressReport report_of(const TaskEnd& end) {
  PressReport report{.button = std::string(end.variable.substr(end.variable.find('.') + 1)),
                     .start_ns = end.start_ns,
                     .end_ns = end.end_ns};
  if (end.failure != nullptr) report.failure = *end.failure;
  return report;
}

}  // namespace

void Session::require_idle(std::string_view what) const {
  if (!is_running_.load()) return;
  throw ArgumentError(
      fmt::format("A session cannot {} while its program runs; use another one.", what));
}

void Session::require_rest(std::string_view what) const {
  if (!is_running_.load() && !run_->is_under_way) return;
  throw ArgumentError("An entry is under way: " + std::string(what) +
                      " when it has ended. run() brings it to its end, cancel() stops it.");
}

void Session::require_run(std::string_view what) const {
  require_idle(what);
  if (run_->vm == nullptr)
    throw ArgumentError(fmt::format("A session cannot {} before its first run.", what));
}

const RunResult& Session::result() const { return run_->result; }
Vm* Session::vm() { return run_->vm.get(); }
const Host* Session::host() const { return run_->host.get(); }

// ---- starts -----------------------------------------------------------------------------------

void Session::begin_next() {
  Run& run = *run_;
  if (submitted_ != nullptr) {
    begin_new(std::move(*std::exchange(submitted_, nullptr)));
  } else if (run.done < run.entries.size()) {
    begin_entry();
  } else if (run.done > 0 && run.entries.front().logged.kind == EntryKind::kProgram) {
    const LoggedEntry& old = run.entries.front().logged;
    Entry again{{.name = old.name, .text = old.text, .imports = old.imports},
                run.entries.front().program};
    run_ = std::make_unique<Run>();
    begin_new(std::move(again));
  } else {
    throw ArgumentError(
        "There is no program to run: compile() was not called, or has found mistakes.");
  }
}

// The entries to come are removed, and restored if this entry is rolled back.
void Session::begin_new(Entry entry) {
  Run& run = *run_;
  const auto first = run.entries.begin() + static_cast<std::ptrdiff_t>(run.done);
  std::vector<Entry> later(std::make_move_iterator(first),
                           std::make_move_iterator(run.entries.end()));
  run.entries.erase(first, run.entries.end());
  const bool is_call = entry.logged.kind == EntryKind::kCall;
  // A session lives long with few entries: their capacity is not doubled.
  if (run.entries.size() == run.entries.capacity())
    run.entries.reserve(run.entries.size() + run.entries.size() / 8 + 1);
  run.entries.push_back(std::move(entry));
  try {
    begin_entry();
  } catch (...) {
    if (is_call) {  // nothing has happened
      run.entries.pop_back();
      std::ranges::move(later, std::back_inserter(run.entries));
      run.journal->resume(run.entries[run.current()].logged, run.has_later());
    }
    throw;
  }
  if (run.before == nullptr) run.before = std::make_unique<Checkpoint>();
  run.before->later = std::move(later);
  if (run.done > 0) return;
  for (const Input& each : early_inputs_) run.journal->expect(each);
}

void Session::begin_entry() {
  Run& run = *run_;
  Entry& entry = run.entries[run.done];
  run.before.reset();
  if (run.vm == nullptr) {
    begin_cell(entry);
  } else {
    if (run.keeps_checkpoints) {
      run.before = std::make_unique<Checkpoint>(Checkpoint{
          std::make_unique<Host>(*run.host), run.names_objects, run.decides_picking, {}});
    }
    if (entry.logged.kind == EntryKind::kCall) {
      find_function(*run.vm, entry.logged.name, entry.logged.arguments.size())
          .begin(entry.logged.arguments);
    } else {
      take_world(*entry.program);
      run.vm->begin(entry.program);
    }
  }
  run.is_under_way = true;
  run.has_run = false;
  run.journal->begin(entry.logged, run.has_later());
  cancel_at(*run.vm, entry.logged.cancelled);
  run.result = run.vm->result();
  entry.moves = static_cast<std::size_t>(run.host->move_count());
  if (!run.is_told && run.fan_out != nullptr) run.host->cell().set_backend(run.fan_out.get());
  run.is_told = true;
  if (entry.program == nullptr) return;
  compilation_.program = entry.program;
  compilation_.sources = {entry.program, &entry.program->sources()};
}

// Makes a new cell, and a virtual machine for the program in it.
void Session::begin_cell(Entry& entry) {
  Run& run = *run_;
  run.journal = std::make_unique<Journal>();
  run.journal->begin(entry.logged, run.entries.size() > 1);
  run.journal->set_silent(is_silent_);
  run.journal->set_keeps_files(options_.keeps_files);
  run.host = make_host(run.journal.get());
  if (options_.world) fill_world(*run.host, *options_.world, problems_);
  take_world(*entry.program);
  if (!options_.backends.empty() || confidant_ != nullptr) {
    run.fan_out = std::make_unique<FanOut>(
        confidant_ == nullptr ? options_.backends : std::vector<Backend*>{confidant_});
    run.fan_out->set_muted(is_silent_ && confidant_ == nullptr);
  }

  VmOptions vm_options;
  vm_options.limits = options_.limits;
  vm_options.timeline = run.host.get();
  vm_options.host = run.host.get();
  vm_options.output = [this, &cell = run.host->cell(),
                       &journal = *run.journal](std::string_view text) {
    cell.note(NoteKind::kOutput, text);
    return journal.print(text,
                         [&] { return options_.output ? options_.output(text) : std::string(); });
  };
  vm_options.advice = [this](const Diagnostic& advice) {
    if (options_.advice && !is_silent_) options_.advice(advice);
  };
  vm_options.stays = options_.laboratory;
  vm_options.on_task_end = [this](const TaskEnd& end) {
    if (options_.on_press && !is_silent_) options_.on_press(report_of(end));
  };
  run.vm = std::make_unique<Vm>(entry.program, std::move(vm_options));
  if (!breakpoints_.empty() && !is_silent_) armlet::set_breakpoints(*run.vm, breakpoints_);
}

// Notes whether the program to run may name objects, and pick them by contact.
void Session::take_world(const Program& program) {
  Run& run = *run_;
  if (!options_.world && program.uses_world())
    run.host->want_world(program.declared_names("object"));
  run.names_objects = run.names_objects || program.mentions("insertObj");
  run.decides_picking =
      run.decides_picking || program.mentions("grasp") || program.mentions("release");
  run.host->cell().set_contact_picking(run.names_objects && !run.decides_picking);
}

// ---- slices -----------------------------------------------------------------------------------

Progress Session::run(const Budget& budget) {
  if (budget.steps == 0)
    throw ArgumentError("A budget of 0 steps lets nothing happen; give at least 1 step.");
  if (budget.statements == 0)
    throw ArgumentError("A budget of 0 statements lets nothing happen; give at least 1.");
  if (budget.statements != Budget::kNoLimit && !options_.markers)
    throw ArgumentError("A run by statements needs a program that was compiled with markers.");
  const OneSlice one_slice(*this);
  try {
    advance(budget);
  } catch (...) {
    break_off();
    throw;
  }
  return run_->result.status;
}

RunResult Session::run() {
  run(Budget{});
  return run_->result;
}

RunResult Session::run_test(std::size_t index) {
  const bool is_program =
      submitted_ != nullptr
          ? submitted_->logged.kind == EntryKind::kProgram
          : !run_->entries.empty() && run_->entries.front().logged.kind == EntryKind::kProgram;
  if (!is_program) throw ArgumentError("Tests are run of a whole program: compile() it.");
  const OneSlice one_slice(*this);
  try {
    give_up();
    if (submitted_ == nullptr) run_->done = run_->entries.size();
    begin_next();
    {
      const InReach in_reach(*this, *run_->vm);
      static_cast<void>(run_->vm->run_test(index));
      finish_slice({});
    }
    end_entry();
  } catch (...) {
    break_off();
    throw;
  }
  return run_->result;
}

// An exception of the host outside of the program ends the run. The virtual machine cannot
// continue.
void Session::break_off() {
  Run& run = *run_;
  if (!run.is_under_way) return;
  run.is_under_way = false;
  if (run.done == 0 && run.is_told) {
    try {
      tell_end();
    } catch (...) {  // the caller gets another exception already
    }
  }
  run.is_told = false;
  run.host->cell().set_backend(nullptr);
  if (run.done == 0) {
    const bool is_program = run.entries.front().logged.kind == EntryKind::kProgram;
    if (is_program) run.done = run.entries.size();  // it can be run again
    if (!is_program) run_ = std::make_unique<Run>();
  } else if (!is_silent_) {
    run.entries.resize(run.done);
    static_cast<void>(go_to_rest(run.done));
  }
}

void Session::advance(const Budget& budget) {
  if (!run_->is_under_way) begin_next();
  {
    const InReach in_reach(*this, *run_->vm);
    run_along(budget);
  }
  if (run_->result.status != Progress::kPaused) end_entry();
}

// Runs the program, and when it has ended the robots that still move.
Progress Session::run_slice(const Budget& budget) {
  Vm& vm = *run_->vm;
  if (vm.result().status == Progress::kPaused) vm.run(budget);
  run_->has_run = true;
  return finish_slice(budget);
}

Progress Session::finish_slice(const Budget& budget) {
  rest(budget);
  RunResult& result = run_->result;
  result = run_->vm->result();
  if (result.status == Progress::kDone && !come_to_rest(budget)) result.status = Progress::kPaused;
  if (result.status == Progress::kDone) bind::report_rests(*run_->vm);
  note_progress();
  return result.status;
}

// A robot may still decelerate when its program has ended. Returns whether all are at rest.
bool Session::come_to_rest(const Budget& budget) {
  Host& host = *run_->host;
  while (const auto next = host.cell().next_event()) {
    const std::int64_t until = std::min(*next, budget.until_ns.value_or(*next));
    if (until <= host.now_ns() && until < *next) return false;
    if (!host.advance_to(until)) break;
  }
  return true;
}

// A robot of a laboratory may still decelerate when its program has ended.
void Session::rest(const Budget& budget) {
  if (!options_.laboratory) return;  // then nothing waits for the host
  Vm& vm = *run_->vm;
  Host& host = *run_->host;
  while (!budget.until_ns && armlet::is_at_rest(vm)) {
    const auto next = host.cell().next_event();
    if (!next || *next <= host.now_ns()) break;
    vm.run({.until_ns = *next});
  }
  // A stop request for the task of a button has now had its effect.
  if (!is_at_rest()) return;
  wish_.forget();
  host.cell().begin();  // listeners get the contents of the cell, even if nothing has moved
}

bool Session::is_at_rest() const {
  return run_->is_under_way && armlet::is_at_rest(*run_->vm) && !run_->host->cell().next_event();
}

void Session::finish() {
  require_idle("finish a run");
  if (!is_at_rest())
    throw ArgumentError("A run is finished when its program and all tasks have ended.");
  armlet::finish(*run_->vm);
  run_->result = run_->vm->result();
  note_progress();
  end_entry();
}

// ---- ends -------------------------------------------------------------------------------------

void Session::end_entry() {
  Run& run = *run_;
  Entry& entry = run.entries[run.done];
  run.is_under_way = false;
  // A stop request that arrived after the last statement is not for the next run.
  static_cast<void>(run.vm->take_cancellation());
  if (entry.logged.kind == EntryKind::kEntry && run.result.status != Progress::kDone) {
    take_back_entry();
    return;
  }
  entry.moves = static_cast<std::size_t>(run.host->move_count()) - entry.moves;
  ++run.done;
  if (run.before != nullptr && !run.before->later.empty()) {
    std::vector<Entry> left(run.entries.begin(), run.entries.end() - 1);
    std::ranges::move(run.before->later, std::back_inserter(left));
    if (!is_silent_) keep_run(log_of(left));
  }
  run.before.reset();
  early_inputs_.clear();
  std::exception_ptr fault;
  try {
    if (run.entries.front().logged.kind == EntryKind::kProgram) tell_end();
  } catch (...) {  // of a backend: the run has ended nevertheless
    fault = std::current_exception();
  }
  apply_due_inputs();
  if (fault) std::rethrow_exception(fault);
}

// The virtual machine has restored its variables; the cell is replaced by its copy.
void Session::take_back_entry() {
  Run& run = *run_;
  const std::unique_ptr<Checkpoint> before = std::move(run.before);
  const RunResult failed = run.result;
  run.entries.erase(run.entries.begin() + static_cast<std::ptrdiff_t>(run.done), run.entries.end());
  if (before == nullptr && run.done > 0) return;  // while going to another time, which this ends
  tell_undone(run, run.done > 0 ? before->host.get() : nullptr);
  if (before != nullptr) std::ranges::move(before->later, std::back_inserter(run.entries));
  if (run.done == 0) {
    std::vector<Entry> later = std::move(run.entries);
    run_ = std::make_unique<Run>();
    run_->entries = std::move(later);
  } else {
    *run.host = std::move(*before->host);
    run.names_objects = before->names_objects;
    run.decides_picking = before->decides_picking;
    run.journal->resume(run.entries[run.done - 1].logged, run.has_later());
    compilation_.program = newest_program();
  }
  run_->result = failed;
}

// host  the present state of the session instead of that of the former run; null: the state before
//       all.
// from  the first event that no longer counts; without it, all events after that state.
void Session::tell_undone(const Run& former, const Host* host, std::optional<std::uint64_t> from) {
  if (former.fan_out == nullptr || former.host == nullptr || is_silent_) return;
  const Cell& there = former.host->cell();
  Undone mark{.t_ns = there.now_ns(), .number = there.events_told()};
  if (host != nullptr) mark.back_ns = host->now_ns();
  mark.from = from.value_or(host != nullptr ? host->cell().events_told() : 0);
  if (mark.from != mark.number || from) former.fan_out->on(mark);
}

// Reports the end to all backends, whatever they throw, and removes them from the cell. The first
// exception is rethrown.
void Session::tell_end() {
  run_->is_told = false;
  Cell& cell = run_->host->cell();
  std::exception_ptr fault;
  const auto tell = [&fault](const auto& part) {
    try {
      part();
    } catch (...) {
      if (!fault) fault = std::current_exception();
    }
  };
  for (const Figure& figure : run_->host->figures()) tell([&] { cell.figure(figure); });
  tell([&] { cell.end(); });
  cell.set_backend(nullptr);
  if (fault) std::rethrow_exception(fault);
}

void Session::give_up() {
  run_->is_under_way = false;
  if (run_->is_told) tell_end();
}

}  // namespace armlet
