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
#include "console/console.hpp"
#include "prompt/line_source.hpp"

namespace armlet::cli {

// The speed of virtual time relative to the wall clock.
class Pace {
 public:
  // factor  seconds of the program per second of the clock; 0: as fast as possible.
  void set(double factor) { factor_ = factor; }
  [[nodiscard]] double factor() const { return factor_; }
  // Starts to measure at this virtual time.
  void begin(std::int64_t t_ns);
  // Waits until the wall clock has reached this virtual time, or Ctrl-C is pressed.
  void wait_for(std::int64_t t_ns) const;

 private:
  double factor_ = 0.0;
  std::int64_t t_ns_ = 0;
  std::int64_t wall_ns_ = 0;
};

class Prompt {
 public:
  // interactive  a person types: prints a greeting, prompts, values and moves.
  Prompt(SessionOptions options, const std::string& robot, bool interactive);

  // Runs entries until the lines end or :quit. Returns the exit status.
  int run(LineSource& lines);

  // Runs one entry. False: it was refused or failed, with a message.
  bool enter(const std::string& text, bool shows_value = true);
  [[nodiscard]] Choices complete(std::string_view before_cursor);

  // ---- for the commands
  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] Pace& pace() { return pace_; }
  [[nodiscard]] const Host& host() const { return *session_.host(); }
  // The entries as a program. Entries that a file cannot contain, such as a question or a second
  // declaration of a name, are comments in it.
  struct Saved {
    std::string text{};
    std::vector<std::string> comments{};  // names of the entries that became comments
  };
  [[nodiscard]] Saved program() const;
  // "t = 0.00 s"
  [[nodiscard]] std::string time() const;
  void quit() { is_done_ = true; }
  // Runs a text that a command of the prompt has made, like enter(): its value is not shown, and it
  // is not part of the program.
  bool enter_aside(const std::string& text);
  // Undoes, or redoes, this number of typed entries. Returns their texts, oldest first.
  std::vector<std::string> undo(std::size_t count);
  std::vector<std::string> redo(std::size_t count);
  // Goes to a time of the session. False: it was cancelled.
  //
  // throws  ArgumentError for a time that the session has not reached.
  bool go_to(std::int64_t t_ns);
  // Goes to the end of a run that was left, as go_to does.
  bool take_up(std::size_t run);
  // The entry in which the session is after going to a time; nullopt: it is between two.
  [[nodiscard]] std::optional<LoggedEntry> under_way() const;
  // Writes the log of the session when it ends; no path: not written. False: it cannot be written.
  using Recorder = std::function<bool(const std::string& path)>;
  void set_recorder(Recorder record) { record_ = std::move(record); }
  bool record(const std::string& path) { return record_(path); }
  // The log of the entries that are not undone, with the marks that `armlet replay --verify`
  // compares.
  [[nodiscard]] SessionLog log() const;

 private:
  Prompt(const SessionOptions& plain, SessionOptions options, const std::string& robot,
         bool interactive);
  SessionOptions listened(SessionOptions options);
  // Runs an empty entry, which makes the cell; it cannot be undone.
  void start();
  void greet();
  // The lines of one entry or command; nullopt at the end.
  std::optional<std::string> read(LineSource& lines);
  bool run_entry(const std::string& text, const std::string& name, bool shows_value);
  // Runs entries again silently. False: Ctrl-C was pressed, and nothing has changed.
  bool again(const std::function<bool()>& go);
  void show_value();
  void show_live(std::int64_t t_ns);
  void end_live();

  std::string robot_;
  bool interactive_;
  bool has_live_;               // a status line can be shown during motions
  bool has_live_line_ = false;  // it is shown now
  bool was_told_ = false;       // a stop request was sent after Ctrl-C
  bool is_done_ = false;
  bool any_failed_ = false;
  int count_ = 0;              // number of typed entries
  std::int64_t shown_ns_ = 0;  // wall-clock time at which the status line was shown
  Pace pace_;
  Recorder record_;
  SessionOptions plain_;  // to check programs
  Session session_;
  std::string before_;  // lines of the entry that is being typed
};

// Whether the line begins with `:` or `?`.
[[nodiscard]] bool is_command(std::string_view line);
// Runs a command. False: it does not exist, or has failed, with a message.
bool run_command(Prompt& prompt, std::string_view line);
// The next part of a command: names of commands, of pages, or an expression from a byte on.
struct CommandPart {
  Choices choices{};
  bool is_expression = false;
  std::size_t begin = 0;
};
[[nodiscard]] CommandPart command_part(std::string_view before_cursor);

}  // namespace armlet::cli
