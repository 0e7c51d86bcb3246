// The text of a laboratory, its runs, and their states at an instant.

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "armlet/backend/event.hpp"
#include "armlet/cell/clock.hpp"
#include "armlet/interpreter/host/stepping.hpp"
#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/laboratory_controls.hpp"
#include "laboratory_state.hpp"

namespace armlet::lab {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

// "line 9: double time = 3.0;": the first line that differs.
std::string what_changed(std::string_view before, std::string_view now) {
  int line = 1;
  while (!before.empty() || !now.empty()) {
    const std::string_view a = before.substr(0, before.find('\n'));
    const std::string_view b = now.substr(0, now.find('\n'));
    if (a != b) return fmt::format("line {}: {}", line, whole_characters(trimmed(b), 60));
    before.remove_prefix(std::min(before.size(), a.size() + 1));
    now.remove_prefix(std::min(now.size(), b.size() + 1));
    ++line;
  }
  return "the same text";
}

// The name of the robot, the field or the button of an input.
std::string name_of(const InputWhat& input) {
  return std::visit(Overload{[](const SetField& each) { return each.name; },
                             [](const PressButton& each) { return each.name; },
                             [](const SetJoints& each) { return each.robot; },
                             [](const SetHand& each) { return each.sliders; }},
                    input);
}

}  // namespace

Laboratory::State::Busy::Busy(State& state, Session& session) : state_(state) {
  const std::lock_guard lock(state_.busy_mutex);
  state_.busy = &session;
}
Laboratory::State::Busy::~Busy() {
  const std::lock_guard lock(state_.busy_mutex);
  state_.busy = nullptr;
}

// ---- the text -------------------------------------------------------------------------------

const Analysis& Laboratory::State::analysis() {
  if (text.is_analysis_old) {
    const Busy guard(*this, text_session);
    text.analysis = text_session.analyse(text.now, options.file, text.analysis);
    text.is_analysis_old = false;
  }
  return *text.analysis;
}

void Laboratory::State::take_text(std::string given, std::int64_t version, bool goes,
                                  int number_of_change) {
  if (given != text.now) {
    text.now = std::move(given);
    text.is_analysis_old = true;
    ++versions.text;
    if (text.document.is_changed && is_same_program(text.now, text.document.text)) {
      text.document.is_changed = false;
      ++versions.document;
    }
  }
  text.version = version;
  text.diagnostics.clear();
  ++versions.diagnostics;
  if (!goes) {
    text.runs = true;
    for (const Diagnostic& each : analysis().diagnostics()) {
      text.diagnostics.push_back(resolved(each, analysis().sources()));
      text.runs = text.runs && each.severity != Severity::kError;
    }
    return;
  }
  auto record = std::make_unique<RunRecord>();
  auto next = std::make_unique<LiveRun>(session_options, options.bounds, *record, files);
  {
    const Busy guard(*this, next->session());
    text.runs = next->begin(text.now, options.file);
  }
  for (const Problem& each : next->session().problems())
    text.diagnostics.push_back(resolved(each.diagnostic, *each.sources));
  if (!text.runs) return;
  end_live_run("Another text has taken its place.");
  record->text_version = version;
  record->number = ++last_run;
  live = std::move(next);
  live_number = record->number;
  list_run(std::move(record), number_of_change);
  breakpoints.known.clear();
  for (const SourceLine& each : armlet::statement_lines(*live->session().program())) {
    if (each.source == 0) breakpoints.known.push_back(each.line);
  }
  ++versions.breakpoints;
}

// Of the many runs of one change, such as a number that is dragged, only the newest is kept.
void Laboratory::State::list_run(std::unique_ptr<RunRecord> record, int number_of_change) {
  const RunRecord* parent = shown_run();
  const bool goes_on = number_of_change != 0 && change.number == number_of_change &&
                       parent != nullptr && parent->number == change.run && parent->inputs.empty();
  if (!goes_on) change = {.number = number_of_change, .run = 0, .before = run_text};
  record->label =
      change.before.empty() ? std::string("the first run") : what_changed(change.before, text.now);
  const int replaced = goes_on ? parent->number : 0;
  if (goes_on) {
    record->parent = parent->parent;
  } else if (parent != nullptr) {
    record->parent = parent->number;
  }
  change.run = record->number;
  run_text = text.now;
  runs.push_back(std::move(record));
  show(last_run);
  if (replaced != 0) drop_run(replaced);
}

// ---- runs -----------------------------------------------------------------------------------

RunRecord* Laboratory::State::find_run(int number) {
  const auto found = std::ranges::find(runs, number, [](const auto& run) { return run->number; });
  return found == runs.end() ? nullptr : found->get();
}

void Laboratory::State::show(int run) {
  shown = run;
  ++versions.shown;
  ++versions.runs;
  drop_old_runs();
}

void Laboratory::State::drop_run(int run) {
  if (plots != nullptr && plots->run() == run) plots.reset();
  if (live_number == run) {
    live.reset();
    live_number = 0;
  }
  forget_look(run);
  if (cursor && cursor->run == run) cursor.reset();
  pages.forget_run(run);
  std::erase_if(runs, [&](const auto& each) { return each->number == run; });
  ++versions.runs;
}

void Laboratory::State::drop_old_runs() {
  const auto bytes = [&] {
    std::size_t sum = 0;
    for (const auto& each : runs) sum += each->bytes();
    return sum;
  };
  while (runs.size() > 1 && (runs.size() > options.most_runs || bytes() > options.most_bytes)) {
    const auto oldest = std::ranges::find_if(runs, [&](const auto& each) {
      return each->number != shown && each->number != live_number;
    });
    if (oldest == runs.end()) break;
    drop_run((*oldest)->number);
  }
}

void Laboratory::State::end_live_run(const std::string& why) {
  if (live == nullptr || live->is_over()) return;
  live->stop(why);
  ++versions.runs;
}

const SessionLog* Laboratory::State::log_of(RunRecord& run) {
  LiveRun* under_way = live_run(run);
  if (under_way != nullptr && !under_way->is_over()) {
    if (under_way->session().vm() == nullptr) return nullptr;
    run.log = under_way->session().log();
  }
  return &run.log;
}

bool Laboratory::State::advance_run() {
  if (live == nullptr || live->is_over()) return false;
  RunRecord& record = *find_run(live_number);
  bool goes_on = false;
  try {
    const Busy guard(*this, live->session());
    goes_on = live->advance();
  } catch (const std::exception& error) {
    live->stop(fmt::format("The run could not go on: {}", error.what()));
  }
  if (fork_asked && live->has_forked()) {
    end_fork();
    return true;
  }
  if (!goes_on) {
    note_parting(record);
    ++versions.runs;
    drop_old_runs();
  } else if (record.bytes() > options.most_bytes / 2) {
    live->stop("The run has filled the memory that a laboratory has for it; it was stopped there.");
    ++versions.runs;
  }
  return goes_on;
}

// A running look begins again, with the new log of the run.
void Laboratory::State::forget_look(int run) {
  if (!looker.is_at(run)) return;
  looker.forget();
  if (looks.now) looks.waiting.push_front(std::move(*looks.now));
  looks.now.reset();
}

void Laboratory::State::forget_looks_of(const RunRecord& run) {
  forget_look(run.number);
  if (plots != nullptr && plots->run() == run.number) plots.reset();
  std::erase(runs_with_plots, run.number);
}

// ---- inputs and plots -----------------------------------------------------------------------

void Laboratory::State::begin_fork(RunRecord& parent, std::int64_t t_ns, const GiveInput& input) {
  auto record = std::make_unique<RunRecord>();
  auto next = std::make_unique<LiveRun>(session_options, options.bounds, *record, files);
  next->begin_fork(parent.log, t_ns, input.what);
  record->label = fmt::format("at {:.2f} s: {}", to_seconds(t_ns), name_of(input.what));
  record->text_version = parent.text_version;
  record->parent = parent.number;
  record->inputs = parent.inputs;
  std::erase_if(record->inputs, [&](const RunInput& each) { return each.t > to_seconds(t_ns); });
  record->number = ++last_run;
  end_live_run("Another run has taken its place.");
  live = std::move(next);
  live_number = record->number;
  runs.push_back(std::move(record));
  show(last_run);
}

// Reports to the page whether the input was accepted. A refused one leaves no run, and the many
// inputs of one slider leave one.
void Laboratory::State::end_fork() {
  const Asked asked = *std::exchange(fork_asked, std::nullopt);
  Page* page = pages.find(asked.page);
  const std::optional<InputFault> fault = live->fork_fault();
  const int number = live_number;
  if (!fault) {
    if (page != nullptr) pages.answer(*page, write_taken(asked.seq, number));
    RunRecord* before = find_run(asked.shown_before);
    RunRecord& now = *find_run(number);
    const bool is_pulled = before != nullptr && !before->inputs.empty() && before->parent &&
                           before->inputs.size() == now.inputs.size() - 1 &&
                           before->inputs.back().t == now.inputs.back().t &&
                           name_of(before->inputs.back().what) == name_of(now.inputs.back().what);
    if (is_pulled) {
      now.parent = before->parent;
      drop_run(before->number);
    }
    return;
  }
  if (page != nullptr) refuse(*page, asked.seq, *fault);
  drop_run(number);
  show(find_run(asked.shown_before) != nullptr ? asked.shown_before : runs.back()->number);
}

// Reads the plots of the shown run when that has ended.
bool Laboratory::State::advance_plots() {
  RunRecord* run = shown_run();
  if (run == nullptr || run->state == RunState::kRunning || !run->lab || !run->lab->has_block)
    return false;
  if (plots != nullptr && plots->run() != run->number) plots.reset();
  if (plots == nullptr) {
    if (std::ranges::find(runs_with_plots, run->number) != runs_with_plots.end()) return false;
    plots = std::make_unique<PlotReader>(session_options, *run);
    for (const ControlState& each = pages.control(); const int page : each.pages) {
      if (Page* told = pages.find(page)) told->runs[run->number].elements.clear();
    }
  }
  bool goes_on = false;
  try {
    const Busy guard(*this, plots->session());
    goes_on = plots->advance();
  } catch (const std::exception&) {
    goes_on = false;  // the readable points are done
  }
  if (!goes_on) {
    runs_with_plots.push_back(run->number);
    plots.reset();
  }
  return goes_on;
}

void Laboratory::State::note_parting(RunRecord& run) {
  const RunRecord* parent = run.parent ? find_run(*run.parent) : nullptr;
  if (parent == nullptr || parent->state == RunState::kRunning) return;
  const std::optional<RunParting> parting = where_runs_part(parent->marks, run.marks);
  run.parts_at = parting ? to_seconds(parting->same_ns) : run.t_end;
  ++run.changes;
}

// ---- looks ----------------------------------------------------------------------------------

// A step begins at the cursor.
void Laboratory::State::begin_look() {
  while (!looks.now && !looks.waiting.empty()) {
    looks.now = std::move(looks.waiting.front());
    looks.waiting.pop_front();
    RunRecord* run = find_run(looks.now->run);
    if (run == nullptr) {
      Page* page = pages.find(looks.now->page);
      if (page != nullptr) refuse(*page, looks.now->seq, "refused", "There is no such run.");
      looks.now.reset();
      continue;
    }
    if (looks.now->step && cursor && cursor->run == looks.now->run)
      looks.now->place = cursor->place;
    looker.go_to(looks.now->run, *log_of(*run), looks.now->place);
  }
}

bool Laboratory::State::advance_look() {
  begin_look();
  if (!looks.now) return false;
  try {
    const Busy guard(*this, looker.session());
    if (looker.is_under_way()) looker.advance();
    if (!looker.is_under_way() && looks.now->step) {
      const StepHow how = *looks.now->step;
      looks.now->step.reset();
      looks.now->has_stepped = true;
      looker.step(how, breakpoints.lines);
    }
    if (looker.was_cancelled()) throw ArgumentError("it takes too long to come there.");
    if (!looker.is_under_way()) end_look();
  } catch (const std::exception& error) {
    Page* page = pages.find(looks.now->page);
    if (page != nullptr)
      refuse(*page, looks.now->seq, "refused",
             fmt::format("This cannot be seen: {}", error.what()));
    looker.forget();
    looks.now.reset();
  }
  return looks.now || !looks.waiting.empty();
}

void Laboratory::State::answer_picture(Page& page) {
  const Look& look = *looks.now;
  LabControls controls(looker.session());
  const Result<LabPicture> picture = controls.picture(look.picture);
  if (!picture) return refuse(page, look.seq, "refused", picture.error().message);
  if (!look.seq) return refuse(page, look.seq, "message", "A question for a picture has a number.");
  pages.answer(page, write_picture(static_cast<std::uint32_t>(*look.seq), *picture));
}

void Laboratory::State::end_look() {
  Page* page = pages.find(looks.now->page);
  if (!looks.now->picture.empty()) {
    if (page != nullptr) answer_picture(*page);
    looks.now.reset();
    return;
  }
  const SeenInstant seen = looker.look();
  if (looks.now->moves_cursor) {
    const LookAt place = looks.now->has_stepped ? looker.place() : looks.now->place;
    cursor = Cursor{.run = looks.now->run,
                    .place = place,
                    .instant = write_instant({}, seen, true),
                    .elements = {}};
    ++versions.cursor;
  }
  std::vector<ElementValue> values;
  const RunRecord* run = find_run(looks.now->run);
  if (run != nullptr && run->lab && run->lab->has_block)
    values = element_values(looker.session(), *run->lab);
  if (cursor && looks.now->moves_cursor)
    cursor->elements = write_elements({}, seen.run, seen.t, values);
  if (page != nullptr && looks.now->looks_only) {
    pages.answer(*page, write_instant(looks.now->seq, seen, false, &values));
  } else if (page != nullptr) {
    pages.answer(*page, write_elements({}, seen.run, seen.t, values));
    pages.answer(*page, write_instant(looks.now->seq, seen, looks.now->moves_cursor));
    if (looks.now->moves_cursor) page->known.cursor = versions.cursor;
  }
  looks.now.reset();
}

}  // namespace armlet::lab
