#pragma once
// Files, messages and interrupts, for all sub-commands.

#include <optional>
#include <string>
#include <string_view>

#include "armlet/stdlib/session.hpp"
#include "commands.hpp"

namespace armlet::cli {

// The text of a file, or nullopt after a message.
std::optional<std::string> read_file(const std::string& path, bool json);

// Says that a file cannot be read, and why.
void show_unreadable(const std::string& path, std::string_view reason, bool json);

void show(const Diagnostic& diagnostic, const SourceSet& sources, bool json);
void show(const std::vector<Problem>& problems, bool json);
// Prints a line of progress on standard error, after all output of the program so far.
void progress(std::string_view line);
// Prints output of the program. The program is stopped when no process reads the output any more.
void print_out(std::string_view text);
[[nodiscard]] bool output_is_read();
// Why output could not be written; empty: all was, or no process reads it any more.
[[nodiscard]] std::string output_fault();
// Whether all output was written. False, after a message unless its reader has ended: it could not
// be written.
bool finish_output();

// "3.2s", "250 ms" or "3.2" (seconds), in nanoseconds; nullopt unless it is a time from 0 to 100
// years.
[[nodiscard]] std::optional<std::int64_t> time_of(const std::string& text);

// The body of main: makes Ctrl-C end the process without leaving unfinished files, calls `dispatch`
// and exits with what it returns. Where nothing reads the output any more, the process ends without
// a message. It exits without freeing the tables of the parser, since the system frees them faster.
[[noreturn]] void run_main(int argc, char** argv, int (*dispatch)(int argc, char** argv));

// While one of these exists, Ctrl-C stops the session under control; a second one ends the process.
class Interruptible {
 public:
  explicit Interruptible(Session& session);
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
};
bool interrupted();
// After this call the next Ctrl-C counts as the first one.
void forget_interrupt();

// While one of these exists, Ctrl-C never ends the process. SIGTERM ends it at once, after
// restoring the terminal.
class StayOnInterrupt {
 public:
  StayOnInterrupt();
  ~StayOnInterrupt();
  StayOnInterrupt(const StayOnInterrupt&) = delete;
  StayOnInterrupt& operator=(const StayOnInterrupt&) = delete;
};

// Whether standard error is a terminal on which a line can be shown and removed again.
[[nodiscard]] bool shows_status();
// Whether a standard stream is a terminal with cursor motion and colours, not a dumb one.
[[nodiscard]] bool is_capable_terminal(int file);
// Shows a line on standard error that the next one overwrites; empty: removes it.
void status_line(std::string_view text);
// Shows the file, the stage and the duration of long work, in one line of a terminal or in many.
void show_stage(const std::string& file, const std::string& stage, int seconds);
// Shows a finished motion as a line of progress.
void show_move(const FinishedMove& move);
// "held by scara", "on table"; empty if it is neither.
std::string place_text(const Cell& cell, std::string_view object);
// "(10 deg, 20 deg, 50 mm)"
std::string joints_text(const CellRobot& robot);

}  // namespace armlet::cli
