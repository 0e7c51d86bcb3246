#include "console/console.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include "armlet/cell/clock.hpp"
#include "armlet/core/files.hpp"
#include "armlet/interpreter/render.hpp"
#include "armlet/interpreter/unit.hpp"
#include "armlet/math/format_vector.hpp"

namespace armlet::cli {
namespace {

std::atomic<Session*> running_session{nullptr};
std::atomic<bool> was_interrupted{false};
std::atomic<bool> stays{false};  // Ctrl-C stops the running program, not the process
int output_failure = 0;          // errno of the first failure

// The settings of the terminal at the start of the process; the prompt changes them.
termios terminal_before{};
std::atomic<bool> has_terminal{false};

void leave_at_once() {
  if (has_terminal.load()) tcsetattr(STDIN_FILENO, TCSANOW, &terminal_before);
  remove_unfinished_files();
  _exit(kStopped);
}

// The first one sends a stop request to the program; without a program, or the second time, it ends
// the process.
extern "C" void on_interrupt(int signal) {
  Session* session = running_session.load();
  if (signal == SIGINT && stays.load()) {
    was_interrupted.store(true);
    if (session != nullptr) session->cancel();
    return;
  }
  if (was_interrupted.exchange(true) || session == nullptr || stays.load()) leave_at_once();
  session->cancel();
}

// No process reads the output any more, as with `| head -1`: the program is stopped.
void note_output_failure() {
  if (output_failure != 0) return;
  output_failure = errno != 0 ? errno : EIO;
  Session* session = running_session.load();
  if (output_failure == EPIPE && session != nullptr) session->cancel();
}

void flush_output() {
  errno = 0;
  if (std::fflush(stdout) != 0) note_output_failure();
}

void write_error(std::string_view text) {
  flush_output();
  std::fwrite(text.data(), 1, text.size(), stderr);
}

// Makes Ctrl-C end the process without leaving unfinished files, and failed writes no signals.
void prepare_process() {
  // Closed standard streams are opened, so that no other file gets their numbers.
  while (true) {
    const int file = open("/dev/null", O_RDONLY);
    if (file > STDERR_FILENO) close(file);
    if (file < 0 || file > STDERR_FILENO) break;
  }
  struct sigaction action {};
  sigemptyset(&action.sa_mask);
  action.sa_handler = on_interrupt;
  for (const int number : {SIGINT, SIGTERM}) sigaction(number, &action, nullptr);
  // Failed writes are handled where they happen.
  action.sa_handler = SIG_IGN;
  for (const int number : {SIGPIPE, SIGXFSZ}) sigaction(number, &action, nullptr);
}

// Ends the process by SIGPIPE, as other commands do when the reader of their pipe has ended.
void end_as_others_do() {
  if (output_is_read()) return;
  std::signal(SIGPIPE, SIG_DFL);
  std::raise(SIGPIPE);
}

}  // namespace

void show_unreadable(const std::string& path, std::string_view reason, bool json) {
  const SourceSet none;
  show(make_diagnostic("E0126", kNoText, {path, std::string(reason)}), none, json);
}

std::optional<std::string> read_file(const std::string& path, bool json) {
  const std::size_t most = ParseLimits{}.bytes;
  // Standard input is named as a file, but may be a pipe.
  Result<std::string> text =
      path == "/dev/stdin" ? read_all(STDIN_FILENO, most) : armlet::read_file(path, most);
  if (text.ok()) return std::move(text).value();
  show_unreadable(path, text.error().message, json);
  return std::nullopt;
}

std::string output_fault() {
  const bool is_told = output_failure != 0 && output_is_read();
  return is_told ? std::string(std::strerror(output_failure)) : std::string();
}

void show(const Diagnostic& diagnostic, const SourceSet& sources, bool json) {
  if (json) {
    write_error(render_json(diagnostic, sources) + "\n");
  } else {
    write_error(render_text(diagnostic, sources, {.color = is_capable_terminal(STDERR_FILENO)}));
  }
}

void show(const std::vector<Problem>& problems, bool json) {
  for (const Problem& problem : problems) show(problem.diagnostic, *problem.sources, json);
}

void progress(std::string_view line) { write_error(fmt::format("{}\n", line)); }

void print_out(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) note_output_failure();
}

bool output_is_read() { return output_failure != EPIPE; }

bool finish_output() {
  flush_output();
  if (output_failure == 0) return true;
  if (output_is_read()) {
    write_error(fmt::format("armlet: what the program printed could not be written: {}\n",
                            std::strerror(output_failure)));
  }
  return false;
}

std::optional<std::int64_t> time_of(const std::string& text) {
  std::string written = text;
  std::erase(written, ' ');
  std::optional<Quantity> quantity = parse_quantity(written);
  if (!quantity) quantity = parse_quantity(written + "s");
  constexpr double kMost = 100.0 * 365.25 * 86400.0;
  if (quantity && quantity->dim == dims::kTime && quantity->si >= 0.0 && quantity->si <= kMost)
    return to_ns(quantity->si);
  return std::nullopt;
}

void run_main(int argc, char** argv, int (*dispatch)(int argc, char** argv)) {
  prepare_process();
  int status = kFailed;
  try {
    status = dispatch(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("armlet: there is not enough memory\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "armlet: a defect of armlet itself: %s\n", error.what());
  }
  end_as_others_do();
#ifdef __SANITIZE_ADDRESS__
  std::exit(status);  // so that leaks are found
#else
  std::fflush(nullptr);
  std::_Exit(status);
#endif
}

Interruptible::Interruptible(Session& session) { running_session = &session; }
Interruptible::~Interruptible() {
  running_session = nullptr;
  flush_output();  // the next interrupt ends the process at once
}

bool interrupted() { return was_interrupted; }
void forget_interrupt() { was_interrupted = false; }

StayOnInterrupt::StayOnInterrupt() {
  has_terminal = tcgetattr(STDIN_FILENO, &terminal_before) == 0;
  stays = true;
}
StayOnInterrupt::~StayOnInterrupt() {
  stays = false;
  has_terminal = false;
}

bool shows_status() { return is_capable_terminal(STDERR_FILENO); }

bool is_capable_terminal(int file) {
  const char* terminal = std::getenv("TERM");
  return isatty(file) != 0 && terminal != nullptr && *terminal != '\0' &&
         std::string_view(terminal) != "dumb";
}

void status_line(std::string_view text) { write_error(fmt::format("\r\033[K{}", text)); }

void show_stage(const std::string& file, const std::string& stage, int seconds) {
  constexpr int kBetweenLines = 10;  // s
  const std::string text = fmt::format("{}: {}, {} s", file, stage, seconds);
  if (shows_status()) {
    status_line(text);
  } else if (seconds % kBetweenLines == 0) {
    progress(text);
  }
}

void show_move(const FinishedMove& move) {
  progress(fmt::format("[t = {:.2f} s] {} {} {:.2f} s{}, hand at {}", move.start + move.duration,
                       move.robot, move.function, move.duration, move.stopped ? " (stopped)" : "",
                       format_point_mm(move.T_world_tool.translation())));
}

std::string place_text(const Cell& cell, std::string_view object) {
  const std::string below = cell.world().resting_on(object);
  if (const auto& held = cell.world().attachment(object); held && held->on.empty())
    return fmt::format("{} {}", held->mounted ? "on" : "held by", cell.robot(held->carrier).name);
  return below.empty() ? below : "on " + below;
}

std::string joints_text(const CellRobot& robot) {
  std::string out;
  for (Eigen::Index i = 0; i < robot.q.size(); ++i) {
    const Joint& joint = robot.model->joint(static_cast<int>(i));
    out += (i == 0 ? "(" : ", ") + format_joint_value(joint.kind, robot.q[i]);
  }
  return out + ")";
}

}  // namespace armlet::cli
