#pragma once
// The prompt: entries and commands, one after the other, in one session (language reference,
// section 21).

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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
  // Waits until it is time, or Ctrl-C is pressed.
  void wait_for(std::int64_t t_ns) const;

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
  bool enter(const std::string& text, bool shows_value = true);
  [[nodiscard]] Choices complete(std::string_view before_cursor);

  // ---- for the commands
  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] Pace& pace() { return pace_; }
  [[nodiscard]] const Host& host() const { return *session_.host(); }
  // What was entered, as a program. What a file does not take, such as a question or a second
  // declaration of a name, is a comment there.
  struct Saved {
    std::string text{};
    std::vector<std::string> comments{};  // names of these entries
  };
  [[nodiscard]] Saved program() const;
  // "t = 0.00 s"
  [[nodiscard]] std::string time() const;
  void quit() { is_done_ = true; }
  // What enter() does for a text that a command is made of: it shows no value, and is no part of
  // the program.
  bool enter_aside(const std::string& text);
  // Back by as many entries that were typed, or forth. Gives their texts, oldest first.
  std::vector<std::string> undo(std::size_t count);
  std::vector<std::string> redo(std::size_t count);
  // To a time of the session. False: somebody stopped it.
  //
  // throws  ArgumentError for a time that the session has not come to.
  bool go_to(std::int64_t t_ns);
  // To where a run had come that was left. As go_to.
  bool take_up(std::size_t run);
  // The line in whose middle the session is, after going there; nothing: it is between two.
  [[nodiscard]] std::optional<LoggedEntry> under_way() const;
  // Where the session is left when it ends; nowhere without a path. False: it cannot be written.
  using Recorder = std::function<bool(const std::string& path)>;
  void set_recorder(Recorder record) { record_ = std::move(record); }
  bool record(const std::string& path) { return record_(path); }
  // The session as it counts, with the marks that `armlet replay --verify` compares.
  [[nodiscard]] SessionLog log() const;

 private:
  Prompt(const SessionOptions& plain, SessionOptions options, const std::string& robot,
         bool interactive);
  SessionOptions listened(SessionOptions options);
  // An empty entry, which makes the cell; nothing goes back behind it.
  void start();
  void greet();
  // The lines of one entry or command; nothing at the end.
  std::optional<std::string> read(LineSource& lines);
  bool run_entry(const std::string& text, const std::string& name, bool shows_value);
  // Runs lines again, unheard. False: Ctrl-C, and all is as it was.
  bool again(const std::function<bool()>& go);
  void show_value();
  void show_live(std::int64_t t_ns);
  void end_live();

  std::string robot_;
  bool interactive_;
  bool has_live_;               // a line under a motion can be shown
  bool has_live_line_ = false;  // it stands there now
  bool was_told_ = false;       // of Ctrl-C: what runs
  bool is_done_ = false;
  bool any_failed_ = false;
  int count_ = 0;              // of entries that were typed
  std::int64_t shown_ns_ = 0;  // wall-clock time of the live line
  Pace pace_;
  Recorder record_;
  SessionOptions plain_;  // to check programs
  Session session_;
  std::string before_;  // lines of the entry that is being typed
};

// A line that begins with `:` or `?`.
[[nodiscard]] bool is_command(std::string_view line);
// False: there is no such command, or it could not be done, as was shown.
bool run_command(Prompt& prompt, std::string_view line);
// What can follow in a command: names of commands, of pages, or an expression from a byte on.
struct CommandPart {
  Choices choices{};
  bool is_expression = false;
  std::size_t begin = 0;
};
[[nodiscard]] CommandPart command_part(std::string_view before_cursor);

}  // namespace armlet::cli
