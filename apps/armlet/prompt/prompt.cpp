// armlet: the prompt.

#include "prompt/prompt.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>
#include <unordered_set>
#include <utility>

#include "armlet/backend/run_marks.hpp"
#include "armlet/core/platform.hpp"
#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/math/format_vector.hpp"
#include "armlet/stdlib/install.hpp"
#include "console/setup.hpp"
#include "run/record.hpp"

namespace armlet::cli {

// ---- time ----------------------------------------------------------------------------------

void Pace::begin(std::int64_t t_ns) {
  t_ns_ = t_ns;
  wall_ns_ = steady_time_ns();
}

void Pace::wait_for(std::int64_t t_ns) const {
  if (factor_ <= 0.0) return;
  const auto due =
      wall_ns_ + static_cast<std::int64_t>(static_cast<double>(t_ns - t_ns_) / factor_);
  while (!interrupted()) {
    const std::int64_t left = due - steady_time_ns();
    if (left <= 0) return;
    std::this_thread::sleep_for(std::chrono::nanoseconds(std::min<std::int64_t>(left, 20'000'000)));
  }
}

// ---- one session ------------------------------------------------------------------------------

namespace {

// The name of entries that are not part of the program: the one at the start, and those of
// commands.
constexpr std::string_view kAside = "command";

// quit, exit(), bye;
bool wants_to_leave(std::string_view text) {
  const std::string_view word = text.substr(0, text.find_first_of("(; \t\n"));
  return word == "quit" || word == "exit" || word == "bye" || word == "q";
}

bool is_typed(const Entry& entry) { return entry.logged.name != kAside; }

// The text with // before each line.
std::string commented(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out += "// " + std::string(text.substr(0, end)) + '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

// Whether the last line is documentation of the declaration in the next one.
bool ends_with_doc(std::string_view text) {
  text.remove_prefix(text.rfind('\n') + 1);
  const std::size_t first = text.find_first_not_of(" \t");
  return first != text.npos && text.substr(first).starts_with("///");
}

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == text.npos; }

}  // namespace

Prompt::Prompt(SessionOptions options, const std::string& robot, bool interactive)
    : Prompt(options, options, robot, interactive) {}

Prompt::Prompt(const SessionOptions& plain, SessionOptions options, const std::string& robot,
               bool interactive)
    : robot_(robot),
      interactive_(interactive),
      has_live_(interactive && shows_status()),
      plain_(plain),
      session_(library_engine(), listened(std::move(options))) {}

// Options with which the prompt shows the events of the session.
SessionOptions Prompt::listened(SessionOptions options) {
  options.pace = [this](std::int64_t t_ns) {
    show_live(t_ns);
    pace_.wait_for(t_ns);
    // Ctrl-C sends one stop request; the deceleration after it does not wait for the clock.
    return !interrupted() || std::exchange(was_told_, true);
  };
  if (interactive_) {
    options.on_move = [this](const FinishedMove& move) {
      end_live();
      show_move(move);
    };
  }
  options.advice = [this](const Diagnostic& advice) {
    end_live();
    show(advice, session_.sources(), false);
  };
  options.output = [this, print = std::move(options.output)](std::string_view text) {
    end_live();
    return print(text);
  };
  return options;
}

void Prompt::start() { enter_aside(""); }

std::string Prompt::time() const {
  return fmt::format("t = {:.2f} s", static_cast<double>(host().now_ns()) * 1e-9);
}

Prompt::Saved Prompt::program() const {
  Session file(library_engine(), plain_);
  Saved saved;
  std::string_view last;  // the last line that is no comment
  std::size_t end = 0;    // its end
  for (const Entry& entry : session_.entries()) {
    if (!is_typed(entry)) continue;
    std::string text = saved.text;
    const std::string_view first_line =
        std::string_view(entry.logged.text).substr(0, entry.logged.text.find('\n'));
    if (!last.empty() && !is_complete(last, first_line)) text.insert(end, ";");
    text += entry.logged.text;
    const std::size_t this_end = text.size();
    if (file.compile(text + '\n', "saved")) {
      saved.text = std::move(text) + '\n';
      last = entry.logged.text;
      end = this_end;
    } else {
      saved.text += commented(entry.logged.text);
      saved.comments.push_back(entry.logged.name);
    }
  }
  return saved;
}

void Prompt::greet() {
  std::string things;
  for (const std::string& name : session_.world_objects())
    things += (things.empty() ? "" : ", ") + name;
  const Robot* model = host().default_robot_model().get();
  progress(fmt::format("Armlet {}   robot {} ({} joints)   {}:help lists commands", ARMLET_VERSION,
                       robot_, model != nullptr ? model->n() : 0,
                       things.empty() ? std::string() : "world: " + things + "   "));
}

// An entry continues as long as the same text in a file would. At a terminal the following line is
// not known, and two empty lines end an incomplete entry.
std::optional<std::string> Prompt::read(LineSource& lines) {
  constexpr int kPatience_ms = 20;  // for an `else` that is still being written into a pipe
  before_.clear();
  int blank = 0;
  while (true) {
    auto line = lines.next(before_.empty() ? "rbt> " : "...> ");
    if (!line && interrupted() && interactive_) return std::string();  // discards the entry
    if (!line) return before_.empty() ? std::nullopt : std::optional(std::exchange(before_, {}));
    if (before_.empty() && (is_blank(*line) || is_command(*line))) return line;
    before_ += (before_.empty() ? "" : "\n") + *line;
    blank = is_blank(*line) ? blank + 1 : 0;
    const bool ends = is_complete(before_) && !ends_with_doc(before_);
    if (!ends && !(interactive_ && blank == 2)) continue;
    const auto next = lines.peek(before_.ends_with('}') ? kPatience_ms : 0);
    if (next && !is_command(*next) && !is_complete(before_, *next)) continue;
    return std::exchange(before_, {});
  }
}

int Prompt::run(LineSource& lines) {
  start();
  if (interactive_) greet();
  while (!is_done_) {
    if (interactive_) forget_interrupt();
    const std::optional<std::string> text = read(lines);
    if (!text || !output_is_read()) break;
    if (is_blank(*text)) continue;
    lines.remember(*text);
    if (interactive_) forget_interrupt();
    const bool done = is_command(*text) ? run_command(*this, *text) : enter(*text);
    any_failed_ = any_failed_ || !done;
    if (interrupted() && !interactive_) return kStopped;
  }
  return finish_output() && (interactive_ || !any_failed_) ? kDone : kFailed;
}

bool Prompt::enter(const std::string& text, bool shows_value) {
  return run_entry(text, fmt::format("[{}]", ++count_), shows_value);
}

// ---- undo and redo

std::optional<LoggedEntry> Prompt::under_way() const {
  const std::size_t done = session_.entries().size();
  if (done == 0 || session_.result().status != Progress::kPaused) return std::nullopt;
  return session_.log().entries[done];
}

bool Prompt::again(const std::function<bool()>& go) {
  const Interruptible guard(session_);
  return go();
}

bool Prompt::go_to(std::int64_t t_ns) {
  return again([&] { return session_.go_to(t_ns); });
}

bool Prompt::take_up(std::size_t run) {
  return again([&] { return session_.take_up(run); });
}

std::vector<std::string> Prompt::undo(std::size_t count) {
  std::vector<std::string> undone;
  const std::size_t done = session_.entries().size();
  if (const auto line = under_way()) {
    const std::int64_t begin_ns = session_.entries()[done - 1].logged.end.t_ns;
    if (!again([&] { return session_.go_to(done - 1, begin_ns); })) return {};
    undone.push_back(line->text);
  }
  std::size_t first = done;
  for (std::size_t i = done; i > 1 && undone.size() < count; --i) {
    const Entry& entry = session_.entries()[i - 1];
    if (!is_typed(entry)) continue;
    first = i - 1;
    undone.insert(undone.begin(), entry.logged.text);
  }
  const bool is_back = first == done || again([&] { return session_.undo(done - first) > 0; });
  show(session_.problems(), false);
  return is_back ? undone : std::vector<std::string>();
}

std::vector<std::string> Prompt::redo(std::size_t count) {
  std::vector<std::string> done;
  if (const auto line = under_way()) {
    const std::size_t entry = session_.entries().size();
    if (!again([&] { return session_.go_to(entry, line->end.t_ns); })) return {};
    done.push_back(line->text);
  }
  while (done.size() < count && again([&] { return session_.redo(1) == 1; })) {
    const Entry& newest = session_.entries().back();
    if (is_typed(newest)) done.push_back(newest.logged.text);
  }
  show(session_.problems(), false);
  return done;
}

// Undone lines are not in this log. Their events were reported to listeners, so the remaining lines
// are run again for the marks.
SessionLog Prompt::log() const {
  SessionLog log = session_.log();
  log.entries.resize(session_.entries().size());
  RunMarks marks;
  SessionOptions options = plain_;
  options.backends = {&marks};
  options.output = {};
  Session once(library_engine(), std::move(options));
  for (bool runs = once.replay(log); runs && once.to_come() > 0;)
    runs = once.run().status == Progress::kDone;
  log.marks = marks.marks();
  return log;
}

bool Prompt::enter_aside(const std::string& text) {
  return run_entry(text, std::string(kAside), false);
}

bool Prompt::run_entry(const std::string& text, const std::string& name, bool shows_value) {
  if (const auto line = under_way()) {
    progress(
        fmt::format("{} is under way at {}: :redo takes it to its end, :undo back to before it",
                    line->name, time()));
    return false;
  }
  const bool compiles = session_.submit(text, name);
  show(session_.problems(), false);
  if (!compiles) {
    if (interactive_ && wants_to_leave(text)) progress("to leave, write :quit or press Ctrl-D");
    return false;
  }
  was_told_ = false;
  pace_.begin(session_.host() != nullptr ? session_.host()->now_ns() : 0);
  {
    const Interruptible guard(session_);
    static_cast<void>(session_.run());
  }
  end_live();
  const RunResult& result = session_.result();
  if (result.status == Progress::kDone) {
    if (shows_value) show_value();
    return true;
  }
  if (result.status == Progress::kCancelled) {
    progress(fmt::format("stopped; {}, all as it was before this line", time()));
  } else if (result.error && output_is_read()) {
    show(*result.error, session_.sources(), false);
  }
  return false;
}

void Prompt::show_value() {
  const std::optional<EntryValue> value = session_.shown();
  if (!value || !interactive_) return;
  if (value->name.empty() && session_.entries().back().moves > 0 && value->type == "Move") return;
  const std::string left = value->name.empty() ? value->text : value->name + " = " + value->text;
  print_out(fmt::format("{:<52}  {}\n", left, value->type));
  static_cast<void>(finish_output());
}

// ---- the status line during a motion -----------------------------------------------------------

void Prompt::show_live(std::int64_t t_ns) {
  constexpr std::int64_t kRefresh_ns = 50'000'000;
  if (!has_live_) return;
  const std::int64_t now = steady_time_ns();
  if (now - shown_ns_ < kRefresh_ns) return;
  shown_ns_ = now;
  const Cell& cell = host().cell();
  std::string line = fmt::format("t = {:.2f} s", static_cast<double>(t_ns) * 1e-9);
  for (int i = 0; i < cell.robot_count(); ++i) {
    if (!cell.is_moving(i)) continue;
    line += fmt::format("   {} {}, hand at {}", cell.robot(i).name, joints_text(cell.robot(i)),
                        format_point_mm(cell.T_world_tool(i).translation()));
  }
  status_line(line);
  has_live_line_ = true;
}

void Prompt::end_live() {
  if (std::exchange(has_live_line_, false)) status_line({});
}

// ---- completion ---------------------------------------------------------------------------------

Choices Prompt::complete(std::string_view before_cursor) {
  std::string_view expression = before_cursor;
  const std::size_t first = before_cursor.find_first_not_of(" \t");
  const bool commands = first != std::string_view::npos &&
                        (before_cursor[first] == ':' || before_cursor[first] == '?');
  if (before_.empty() && commands) {
    const CommandPart part = command_part(before_cursor);
    if (!part.is_expression) return part.choices;
    expression.remove_prefix(part.begin);
  }
  const std::string text = before_ + (before_.empty() ? "" : "\n") + std::string(expression);
  const auto at = static_cast<std::uint32_t>(text.size());
  const Completions found = session_.analyse(text, "line")->completion(at);
  Choices choices;
  choices.word_bytes = at - std::min(at, found.replaced.begin);
  const std::string_view word = std::string_view(text).substr(at - choices.word_bytes);
  std::unordered_set<std::string_view> met;
  for (const Completion& item : found.items) {
    if (item.text.starts_with(word) && met.insert(item.text).second)
      choices.texts.push_back(item.text);
  }
  return choices;
}

// ---- the command --------------------------------------------------------------------------------

namespace {

// The history file, in the user's folder for the state of programs; empty: there is none.
std::string history_file() {
  namespace fs = std::filesystem;
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  fs::path folder;
  if (state != nullptr && *state == '/') {
    folder = state;
  } else if (home != nullptr && *home == '/') {
    folder = fs::path(home) / ".local" / "state";
  } else {
    return {};
  }
  std::error_code failed;
  fs::create_directories(folder / "armlet", failed);
  return failed ? std::string() : (folder / "armlet" / "history").string();
}

bool can_edit_lines() {
  return is_capable_terminal(STDIN_FILENO) && is_capable_terminal(STDOUT_FILENO);
}

}  // namespace

int prompt(const PromptOptions& options) {
  Setup setup = make_setup(options.program, "");
  if (setup.exit != kDone) return setup.exit;
  Record record;
  if (const int exit = record.choose(options.record); exit != kDone) return exit;
  if (const int exit = record.open({options.program.world}); exit != kDone) return exit;
  const bool interactive = isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
  std::optional<StayOnInterrupt> stay;
  if (interactive) stay.emplace();
  Prompt session(std::move(setup.session), options.program.robot, interactive);
  session.set_recorder([&](const std::string& path) {
    record.give_up();
    if (path.empty()) return true;
    if (record.choose(path) == kDone && record.open({options.program.world}) == kDone) return true;
    record.give_up();
    return false;
  });
  std::unique_ptr<LineSource> lines;
  if (can_edit_lines()) {
    lines = edited_lines([&](std::string_view before) { return session.complete(before); },
                         history_file());
  }
  if (lines == nullptr) lines = plain_lines(interactive);
  const int exit = session.run(*lines);
  if (!record.is_wanted()) return exit;
  const int recorded = record.finish(session.log());
  return exit == kDone ? recorded : exit;
}

}  // namespace armlet::cli
