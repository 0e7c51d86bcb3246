#pragma once
// The prompt: entries and commands, one after the other, in one session (language reference, section 21).

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/stdlib/session.hpp"
#include "console.hpp"
#include "prompt/line_source.hpp"

namespace armlet::cli {

// Time of the prompt against the wall clock.
class Pace {
 public:
  // factor  seconds of the program in one of the clock; 0: as fast as can be computed.
  void set(double factor) { factor_ = factor; }
  [[nodiscard]] double factor() const { return factor_; }
  // From here on, at this virtual time.
  void begin(std::int64_t t_ns);
  // Waits until it is time. False: Ctrl-C was pressed.
  [[nodiscard]] bool wait_for(std::int64_t t_ns) const;

 private:
  double factor_ = 0.0;
  std::int64_t t_ns_ = 0;
  std::int64_t wall_ns_ = 0;
};

class Prompt {
 public:
  // interactive  a person types: greets, asks, shows values and moves.
  Prompt(SessionOptions options, const std::string& robot, bool interactive);

  // Until the lines end or :quit. The exit status.
  int run(LineSource& lines);

  // One entry. False: it was refused or failed, as was shown.
  bool enter(const std::string& text);
  [[nodiscard]] Choices complete(std::string_view before_cursor);

  // ---- for the commands
  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] Pace& pace() { return pace_; }
  // The cell, which an empty entry makes if there was none.
  [[nodiscard]] const Host& host();
  // The entries that can be saved, joined as a program.
  [[nodiscard]] std::string program() const;
  // "t = 0.00 s"
  [[nodiscard]] std::string time();
  void quit() { is_done_ = true; }
  // What enter() does, but the entry is not part of the program.
  bool enter_aside(const std::string& text);

 private:
  SessionOptions listened(SessionOptions options);
  void greet();
  // The lines of one entry or command; nothing at the end.
  std::optional<std::string> read(LineSource& lines);
  bool run_entry(const std::string& text, const std::string& name, bool shows_value);
  void show_value();
  void show_live(std::int64_t t_ns);
  void end_live();

  std::string robot_;
  bool interactive_;
  bool has_live_line_ = false;
  bool is_done_ = false;
  bool any_failed_ = false;
  int count_ = 0;  // of entries that were typed
  std::int64_t shown_ns_ = 0;  // wall-clock time of the live line
  Pace pace_;
  Session session_;
  std::string before_;  // lines of the entry that is being typed
};

// A line that begins with `:` or `?`.
[[nodiscard]] bool is_command(std::string_view line);
// False: there is no such command, or it could not be done, as was shown.
bool run_command(Prompt& prompt, std::string_view line);
// Of commands that begin so.
[[nodiscard]] std::vector<std::string> commands_with(std::string_view start);

}  // namespace armlet::cli
