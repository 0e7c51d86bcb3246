#pragma once
// Files, messages and interrupts, for all sub-commands.

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "armlet/model/robot.hpp"
#include "armlet/stdlib/session.hpp"
#include "commands.hpp"

namespace armlet::cli {

// The text of a file, or nothing after a message.
std::optional<std::string> read_file(const std::string& path, bool json);

// The packages of --package NAME=DIR and the folders of ROS_PACKAGE_PATH.
PackageFolders package_folders(const std::vector<std::string>& named);

// The options of a session for a program, with the robot and world asked for, or the exit status
// after a message.
struct Setup {
  SessionOptions session;
  int exit = kDone;
};
// Converts meshes of programs, with a cache; says so after a while.
MeshConverter mesh_converter();
Setup make_setup(const ProgramOptions& options, const std::string& file);

// The robot of that name of the catalogue, or null after a message.
std::shared_ptr<const Robot> find_robot(const std::string& name);

void show(const Diagnostic& diagnostic, const SourceSet& sources, bool json);
void show(const std::vector<Problem>& problems, bool json);
// A line of progress on standard error, after everything that the program printed.
void progress(std::string_view line);
// What the program prints. When nobody reads it any more the program is stopped.
void print_out(std::string_view text);
[[nodiscard]] bool output_is_read();
// Everything printed arrived. False, after a message unless nobody reads: the outside could not
// take it.
bool finish_output();

// "3.2s", "250 ms" or "3.2", which are seconds, in nanoseconds; nothing for what is no time from 0
// to 100 years.
[[nodiscard]] std::optional<std::int64_t> time_of(const std::string& text);

// Before anything else: from here on Ctrl-C ends the process and leaves no unfinished files, and
// output that nobody reads ends it quietly (end_as_others_do).
void prepare_process();
// Ends the process by SIGPIPE, as commands in a pipe end whose reader has left.
void end_as_others_do();

// While one of these lives, Ctrl-C stops the session under control; a second one ends the process.
class Interruptible {
 public:
  explicit Interruptible(Session& session);
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
};
bool interrupted();
// The next Ctrl-C is the first one again.
void forget_interrupt();

// While one of these lives, Ctrl-C never ends the process, and SIGTERM does so at once, with the
// terminal as it was.
class StayOnInterrupt {
 public:
  StayOnInterrupt();
  ~StayOnInterrupt();
  StayOnInterrupt(const StayOnInterrupt&) = delete;
  StayOnInterrupt& operator=(const StayOnInterrupt&) = delete;
};

// Whether standard error is a terminal that can show a line and take it away again.
[[nodiscard]] bool shows_status();
// Whether a standard stream is a terminal that moves its cursor and has colours; a dumb one is not.
[[nodiscard]] bool is_capable_terminal(int file);
// A line of a terminal's standard error that the next one takes the place of; empty: none.
void status_line(std::string_view text);
// A motion that has ended, as a line of progress.
void show_move(const MoveReport& move);
// "held by scara", "on table"; empty if it is neither.
std::string place_text(const Cell& cell, std::string_view object);
// "(10 deg, 20 deg, 50 mm)"
std::string joints_text(const CellRobot& robot);

}  // namespace armlet::cli
