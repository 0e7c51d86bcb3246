// The log of a session, and replays: of a log, to another time, to another entry.

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/core/format.hpp"
#include "armlet/interpreter/host/stepping.hpp"
#include "session/run.hpp"

namespace armlet {
namespace {

bool is_same(const RunLimits& a, const RunLimits& b) {
  return a.steps == b.steps && a.heap_bytes == b.heap_bytes && a.call_depth == b.call_depth &&
         a.output_bytes == b.output_bytes && a.time_ns == b.time_ns;
}

// The first difference between the logs of two sessions; empty: none that affects a run.
std::string difference(const SessionLog& ours, const SessionLog& theirs) {
  const auto named = [](const std::string& name) {
    return name.empty() ? std::string("none") : '"' + name + '"';
  };
  if (ours.robot != theirs.robot) {
    return fmt::format("the robot of the log is {}, that of the session {}", named(theirs.robot),
                       named(ours.robot));
  }
  if (ours.planners != theirs.planners) return "the log was made with other planners of the host";
  if (ours.frames != theirs.frames) return "the log was made with other cameras of the host";
  if (ours.world != theirs.world || ours.default_world != theirs.default_world)
    return "the log was made in another world";
  if (ours.laboratory != theirs.laboratory)
    return theirs.laboratory ? "the log is of a laboratory" : "the session is that of a laboratory";
  if (!is_same(ours.limits, theirs.limits)) return "the log was made with other limits of runs";
  const auto& entries = theirs.entries;
  if (entries.empty()) return "the log holds no entry";
  for (const LoggedEntry& each : entries) {
    const bool is_first = &each == &entries.front();
    if (each.kind == EntryKind::kCall
            ? is_first
            : each.kind != entries.front().kind || (each.kind == EntryKind::kProgram && !is_first))
      return "its entries cannot follow each other: a program, or entries, and calls behind them";
  }
  return {};
}

}  // namespace

// ---- the log ----------------------------------------------------------------------------------

SessionLog Session::log_of(const std::vector<Entry>& entries) const {
  SessionLog log;
  if (options_.robot != nullptr) log.robot = options_.robot->name();
  for (const NamedPlanner& each : options_.planners) log.planners.push_back(each.name);
  log.frames = options_.frames.cameras;
  log.world = options_.world;
  log.default_world = options_.default_world;
  log.limits = options_.limits;
  log.open = options_.open;
  log.laboratory = options_.laboratory;
  for (const Entry& each : entries) log.entries.push_back(each.logged);
  return log;
}

SessionLog Session::log() const {
  require_idle("give its log");
  static_cast<void>(sources());
  SessionLog log = log_of(run_->entries);
  if (log.entries.empty() && submitted_ != nullptr) log.entries.push_back(submitted_->logged);
  return log;
}

namespace {

// Approximate size of the texts and inputs in a log, bytes.
std::size_t bytes_of(const SessionLog& log) {
  std::size_t bytes = sizeof log;
  for (const LoggedEntry& entry : log.entries) {
    bytes += sizeof entry + entry.text.size() + entry.inputs.size() * sizeof(Input);
    for (const Reply& reply : entry.replies)
      bytes += sizeof reply + reply.question.size() + reply.text.size();
    for (const LoggedImport& import : entry.imports)
      bytes += sizeof import + (import.given.text ? import.given.text->size() : 0);
  }
  return bytes;
}

}  // namespace

void Session::keep_run(SessionLog run) {
  runs_.push_back(std::move(run));
  std::size_t bytes = 0;
  std::size_t kept = 0;  // the newest one is always kept
  while (kept < std::min(runs_.size(), kMostRuns)) {
    bytes += bytes_of(runs_[runs_.size() - 1 - kept]);
    if (kept > 0 && bytes > kMostRunBytes) break;
    ++kept;
  }
  runs_.erase(runs_.begin(), runs_.end() - static_cast<std::ptrdiff_t>(kept));
}

// The entries of a log, compiled; fewer if one of them cannot run.
std::vector<Entry> Session::compile_log(const SessionLog& log) {
  std::vector<Entry> entries;
  std::shared_ptr<const Program> newest;
  for (const LoggedEntry& each : log.entries) {
    Entry entry{.logged = each, .program = nullptr};
    if (each.kind != EntryKind::kCall) {
      Compiled made = compile_text(each, newest, true);
      problems_ = std::move(made.problems);
      compilation_ = std::move(made.compilation);
      if (!made.can_run) break;
      newest = entry.program = compilation_.program;
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

bool Session::replay(const SessionLog& log) {
  require_idle("replay a log");
  if (const std::string why = difference(log_of({}), log); !why.empty())
    throw ArgumentError("This log cannot be replayed here: " + why + '.');
  give_up();
  submitted_.reset();
  run_ = std::make_unique<Run>();
  world_replies_ = log.entries.front().replies;
  std::vector<Entry> entries = compile_log(log);
  if (entries.size() < log.entries.size()) return false;
  run_->entries = std::move(entries);
  return true;
}

// ---- to another time --------------------------------------------------------------------------

std::size_t Session::entry_at(std::int64_t t_ns) const {
  const std::vector<Entry>& entries = run_->entries;
  std::size_t at = 0;
  while (at + 1 < entries.size() && entries[at].logged.end.t_ns <= t_ns) ++at;
  return at;
}

void Session::require_time(std::size_t entry, std::int64_t t_ns) const {
  const std::vector<Entry>& entries = run_->entries;
  const auto seconds = [](std::int64_t ns) { return format_number(to_seconds(ns), 9); };
  const std::int64_t last = entries.empty() ? 0 : entries.back().logged.end.t_ns;
  if (t_ns < 0 || t_ns > last) {
    throw ArgumentError(fmt::format("The run has come to t = {} s; there is no t = {} s to go to.",
                                    seconds(last), seconds(t_ns)));
  }
  if (entries.empty() && submitted_ != nullptr) return;
  if (entry >= entries.size()) {
    throw ArgumentError(fmt::format("There are {} entries; there is no entry {} to go to, from 0.",
                                    entries.size(), entry));
  }
  const std::int64_t begin = entry == 0 ? 0 : entries[entry - 1].logged.end.t_ns;
  const std::int64_t end = entries[entry].logged.end.t_ns;
  if (t_ns >= begin && t_ns <= end) return;
  throw ArgumentError(
      fmt::format("Entry {} lasts from t = {} s to t = {} s; t = {} s is not in it.", entry,
                  seconds(begin), seconds(end), seconds(t_ns)));
}

// Runs the first `count` entries. False: the run was cancelled, or an entry failed.
bool Session::run_through(std::size_t count) {
  run_->keeps_checkpoints = false;
  while (run_->done < count && !wish_.is_there.load()) {
    const std::size_t before = run_->done;
    advance({});
    if (run_->done == before) break;
  }
  run_->keeps_checkpoints = true;
  return run_->done == count;
}

// Runs to the end of this time if the entry went beyond it; otherwise exactly to the instant that
// the entry had reached, which may be between the events of one time.
bool Session::run_again_to(std::size_t entry, std::int64_t t_ns) {
  if (!run_through(entry)) return false;
  const Instant end = run_->entries[entry].logged.end;
  if (t_ns < end.t_ns) {
    advance({.until_ns = t_ns});
  } else {
    if (t_ns > instant().t_ns) advance({.until_ns = t_ns - 1});
    const bool goes_on = !run_->is_under_way && run_->done == entry;
    if (goes_on || run_->is_under_way) {
      const std::uint64_t steps = instant().steps;
      if (end.steps > steps) {
        advance({.until_ns = t_ns, .steps = end.steps - steps});
      } else if (goes_on || instant().t_ns < t_ns) {
        advance({.until_ns = t_ns});
      }
      apply_due_inputs();
    }
  }
  return run_->is_under_way || run_->done > entry;
}

// The present run is stored while the entries are run again, and restored if that fails.
bool Session::take_again(std::vector<Entry> entries, const std::function<bool()>& go,
                         std::optional<std::uint64_t> undone_from) {
  std::unique_ptr<Run> former = std::exchange(run_, std::make_unique<Run>());
  const Compilation compiled = compilation_;
  const auto bring_back = [&] {
    run_ = std::move(former);
    compilation_ = compiled;
    is_silent_ = false;
    wish_.forget();
  };
  run_->entries = std::move(entries);
  is_silent_ = true;
  bool is_there = false;
  try {
    is_there = go() && !wish_.is_there.load();
  } catch (...) {
    bring_back();
    throw;
  }
  if (!is_there) {
    const std::optional<Diagnostic> error = run_->result.error;
    if (error && !wish_.is_there.load()) problems_ = {{*error, compilation_.sources}};
    bring_back();
    return false;
  }
  is_silent_ = false;
  if (confidant_ == nullptr) tell_undone(*former, run_->host.get(), undone_from);
  if (run_->journal != nullptr) run_->journal->set_silent(false);
  if (run_->fan_out != nullptr) run_->fan_out->set_muted(false);
  if (run_->vm != nullptr && !breakpoints_.empty())
    armlet::set_breakpoints(*run_->vm, breakpoints_);
  return true;
}

bool Session::go_to_rest(std::size_t count) {
  problems_.clear();
  return take_again(run_->entries, [this, count] { return run_through(count); });
}

bool Session::go_to(std::int64_t t_ns) {
  require_idle("go to another time");
  return go_to(entry_at(t_ns), t_ns);
}

bool Session::go_to(std::size_t entry, std::int64_t t_ns) {
  require_idle("go to another time");
  static_cast<void>(sources());
  require_time(entry, t_ns);
  const OneSlice one_slice(*this);
  if (run_->entries.empty()) {  // it has not begun
    return take_again({*submitted_}, [this] {
      begin_next();
      return true;
    });
  }
  return take_again(run_->entries, [this, entry, t_ns] { return run_again_to(entry, t_ns); });
}

bool Session::take_up(std::size_t run) {
  require_idle("take up another run");
  if (run >= runs_.size()) {
    throw ArgumentError(fmt::format("{} runs were left; there is no run {} to take up, from 0.",
                                    runs_.size(), run));
  }
  const OneSlice one_slice(*this);
  SessionLog present = log_of(run_->entries);
  const Compilation compiled = compilation_;
  std::vector<Entry> entries = compile_log(runs_[run]);
  compilation_ = compiled;
  const std::size_t last = entries.size() - 1;
  const std::int64_t t_ns = entries.back().logged.end.t_ns;
  const auto go = [this, last, t_ns] { return run_again_to(last, t_ns); };
  // Listeners know only the begin event of the other run, so all later events are undone.
  if (!take_again(std::move(entries), go, 1)) return false;
  runs_[run] = std::move(present);
  submitted_.reset();
  return true;
}

}  // namespace armlet
