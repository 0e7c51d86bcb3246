// armlet: the prompt.

#include "prompt/prompt.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>
#include <utility>

#include "armlet/core/format.hpp"
#include "armlet/core/platform.hpp"
#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/stdlib/install.hpp"

namespace armlet::cli {

// ---- time ----------------------------------------------------------------------------------

void Pace::begin(std::int64_t t_ns) {
  t_ns_ = t_ns;
  wall_ns_ = steady_time_ns();
}

bool Pace::wait_for(std::int64_t t_ns) const {
  if (factor_ <= 0.0) return true;
  const auto due = wall_ns_ + static_cast<std::int64_t>(static_cast<double>(t_ns - t_ns_) / factor_);
  while (!interrupted()) {
    const std::int64_t left = due - steady_time_ns();
    if (left <= 0) return true;
    std::this_thread::sleep_for(std::chrono::nanoseconds(std::min<std::int64_t>(left, 20'000'000)));
  }
  return false;
}

// ---- one session ------------------------------------------------------------------------------

namespace {

// Entries that commands make carry this name; they are no part of the program.
constexpr std::string_view kAside = "command";

}  // namespace

Prompt::Prompt(SessionOptions options, const std::string& robot, bool interactive)
    : robot_(robot),
      interactive_(interactive),
      session_(library_engine(), listened(std::move(options))) {}

// What the session tells is shown here.
SessionOptions Prompt::listened(SessionOptions options) {
  options.pace = [this](std::int64_t t_ns) {
    if (pace_.factor() > 0.0) show_live(t_ns);
    return pace_.wait_for(t_ns);
  };
  if (interactive_) {
    options.on_move = [this](const MoveReport& move) {
      end_live();
      show_move(move);
    };
  }
  options.advice = [this](const Diagnostic& advice) { show(advice, session_.sources(), false); };
  return options;
}

const Host& Prompt::host() {
  if (session_.host() == nullptr) enter_aside("");
  return *session_.host();
}

std::string Prompt::time() { return fmt::format("t = {:.2f} s", static_cast<double>(host().now_ns()) * 1e-9); }

std::string Prompt::program() const {
  std::string out;
  for (const Entry& entry : session_.entries()) {
    if (entry.name.starts_with(kAside)) continue;
    out += entry.text;
    if (!out.empty() && out.back() != '\n') out += '\n';
  }
  return out;
}

void Prompt::greet() {
  std::string things;
  for (const std::string& name : host().cell().world().names()) things += (things.empty() ? "" : ", ") + name;
  const Robot* model = host().default_robot_model();
  progress(fmt::format("Armlet {}   robot {} ({} joints)   {}? for help", ARMLET_VERSION, robot_,
                       model != nullptr ? model->n() : 0,
                       things.empty() ? std::string() : "world: " + things + "   "));
}

// The entry goes on as long as the same text in a file would.
std::optional<std::string> Prompt::read(LineSource& lines) {
  before_.clear();
  while (true) {
    auto line = lines.next(before_.empty() ? "rbt> " : "...> ");
    if (!line && interrupted()) return std::string();  // what was typed is forgotten
    if (!line) return before_.empty() ? std::nullopt : std::optional(std::exchange(before_, {}));
    if (before_.empty() && is_command(*line)) return line;
    const bool is_blank = line->find_first_not_of(" \t") == std::string::npos;
    if (before_.empty() && is_blank) return line;
    before_ += (before_.empty() ? "" : "\n") + *line;
    // An empty line ends what cannot be completed, and says so.
    if (is_blank || is_complete(before_)) return std::exchange(before_, {});
  }
}

int Prompt::run(LineSource& lines) {
  if (interactive_) greet();
  while (!is_done_) {
    forget_interrupt();
    const std::optional<std::string> text = read(lines);
    if (!text || !output_is_read()) break;
    if (text->find_first_not_of(" \t\n") == std::string::npos) continue;
    lines.remember(*text);
    forget_interrupt();
    const bool done = is_command(*text) ? run_command(*this, *text) : enter(*text);
    any_failed_ = any_failed_ || !done;
  }
  return finish_output() && (interactive_ || !any_failed_) ? kDone : kFailed;
}

bool Prompt::enter(const std::string& text) {
  return run_entry(text, fmt::format("line {}", ++count_), true);
}

bool Prompt::enter_aside(const std::string& text) { return run_entry(text, std::string(kAside), false); }

bool Prompt::run_entry(const std::string& text, const std::string& name, bool shows_value) {
  const bool compiles = session_.submit(text, name);
  show(session_.problems(), false);
  if (!compiles) return false;
  if (session_.host() != nullptr) pace_.begin(session_.host()->now_ns());
  {
    const Interruptible guard(session_);
    session_.run();
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
  const std::string left = value->name.empty() ? value->text : value->name + " = " + value->text;
  print_out(fmt::format("{:<52}  {}\n", left, value->type));
  static_cast<void>(finish_output());
}

// ---- the line under a motion -------------------------------------------------------------------

void Prompt::show_live(std::int64_t t_ns) {
  constexpr std::int64_t kRefresh_ns = 50'000'000;
  const Host* host = session_.host();
  if (!interactive_ || isatty(STDERR_FILENO) == 0 || host == nullptr) return;
  const std::int64_t now = steady_time_ns();
  if (now - shown_ns_ < kRefresh_ns) return;
  shown_ns_ = now;
  std::string line = fmt::format("t = {:.2f} s", static_cast<double>(t_ns) * 1e-9);
  for (int i = 0; i < host->cell().robot_count(); ++i) {
    if (!host->cell().is_moving(i)) continue;
    line += fmt::format("   {} at {}", host->cell().robot(i).name, joints_text(host->cell().robot(i)));
    line += ", hand at " + format_point_mm(host->cell().T_world_tool(i).translation());
  }
  status_line(line);
  has_live_line_ = true;
}

void Prompt::end_live() {
  if (std::exchange(has_live_line_, false)) status_line({});
}

// ---- completion ----------------------------------------------------------------------------------

Choices Prompt::complete(std::string_view before_cursor) {
  if (before_.empty() && is_command(before_cursor)) {
    const std::size_t space = before_cursor.find(' ');
    if (before_cursor.front() == ':' && space == std::string_view::npos)
      return {before_cursor.size(), commands_with(before_cursor)};
  }
  const std::string text = before_ + (before_.empty() ? "" : "\n") + std::string(before_cursor);
  const auto at = static_cast<std::uint32_t>(text.size());
  const auto analysis = session_.analyse(text, "line");
  const Completions found = analysis->completion(at);
  Choices choices;
  choices.word_bytes = at - std::min(at, found.replaced.begin);
  const std::string_view word = std::string_view(text).substr(at - choices.word_bytes);
  for (const Completion& item : found.items) {
    if (item.text.starts_with(word) && std::ranges::find(choices.texts, item.text) == choices.texts.end())
      choices.texts.push_back(item.text);
  }
  return choices;
}

// ---- the command -----------------------------------------------------------------------------------

namespace {

// Below the folder that the system has for the state of programs; empty: there is none.
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
  const char* terminal = std::getenv("TERM");
  return isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0 && terminal != nullptr &&
         *terminal != '\0' && std::string_view(terminal) != "dumb";
}

}  // namespace

int prompt(const ProgramOptions& options) {
  Setup setup = make_setup(options, "");
  if (setup.exit != kDone) return setup.exit;
  const bool interactive = isatty(STDIN_FILENO) != 0;
  const StayOnInterrupt stay;
  Prompt session(std::move(setup.session), options.robot, interactive);
  std::unique_ptr<LineSource> lines;
  if (can_edit_lines()) {
    lines = edited_lines([&](std::string_view before) { return session.complete(before); },
                         history_file());
  }
  if (lines == nullptr) lines = plain_lines(interactive);
  return session.run(*lines);
}

}  // namespace armlet::cli
