#pragma once
// Shows a run at an instant: replays it silently up to there.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "armlet/interpreter/host/stepping.hpp"
#include "armlet/stdlib/session.hpp"
#include "messages/request.hpp"
#include "messages/text_places.hpp"
#include "seen_things.hpp"

namespace armlet::lab {

// The state of a run at an instant.
//
// line, span  of the statement that has begun last or is about to begin; 0: none has.
// statements  number of statements that have begun.
struct SeenInstant {
  // scope  0: the top level; then the calls of the task, from outside to inside.
  // value  nullopt: it has none yet.
  struct Variable {
    int scope = 0;
    std::string name{}, type{};
    std::optional<std::string> value{};
    std::optional<TextSpan> declared{};
  };
  // calls  the names of its functions, the innermost last.
  struct Task {
    std::string name{}, waits{};
    int line = 0;
    std::optional<TextSpan> span{};
    std::vector<std::string> calls{};
  };
  int run = 0;
  double t = 0.0;
  int line = 0;
  std::optional<TextSpan> span{};
  std::uint64_t statements = 0;
  bool is_at_breakpoint = false;
  bool has_ended = false;
  std::vector<Variable> variables{};
  std::vector<Task> tasks{};
  std::vector<std::pair<std::string, SignalValue>> signals{};
  SeenThings things{};
};

// An instant of a run: after all events up to a time, or after this number of statements has begun
// and before the next one.
struct LookAt {
  std::int64_t t_ns = 0;
  std::optional<std::uint64_t> statements{};
  bool operator==(const LookAt&) const = default;
};

// Goes to one instant at a time: a new one replaces the one before.
class Looker {
 public:
  explicit Looker(SessionOptions options);
  ~Looker();

  // Begins to go to an instant of the run with this number and log. From an earlier instant of the
  // same run it continues.
  void go_to(int run, const SessionLog& log, LookAt place);
  // Begins a step from the present instant; breakpoints end it as well.
  void step(StepHow how, const std::vector<int>& breakpoints);
  // Works for a while. Returns whether there is more to do.
  bool advance();
  [[nodiscard]] bool is_under_way() const { return aim_ != Aim::kNothing; }
  [[nodiscard]] bool is_at(int run) const { return session_ != nullptr && run_ == run; }

  [[nodiscard]] SeenInstant look();
  // The present instant, in a form to which go_to can return.
  [[nodiscard]] LookAt place();
  // Must be called when the log of the run has changed.
  void forget();
  // The session of the run; it exists after go_to.
  [[nodiscard]] Session& session() { return *session_; }
  [[nodiscard]] bool was_cancelled() const {
    return session_ != nullptr && session_->result().status == Progress::kCancelled;
  }

 private:
  // kStatement: to the end of the present statement.
  enum class Aim : std::uint8_t { kNothing, kTime, kStatements, kStatement, kStep, kBreakpoint };
  struct Focus {
    std::string task;
    std::size_t depth = 0;
    Span at{};
  };

  void restart(const SessionLog& log);
  bool run_slice(Budget budget);
  [[nodiscard]] bool has_ended() const;
  // Whether nothing more happens: the run has ended, or waits for an input.
  [[nodiscard]] bool is_over() const;
  [[nodiscard]] std::int64_t now_ns() const;
  [[nodiscard]] std::uint64_t begun() const;
  [[nodiscard]] Focus focus() const;
  [[nodiscard]] bool is_step_done() const;
  void set_breakpoints();
  bool begin_statements();
  void arrive();

  SessionOptions options_;
  std::unique_ptr<Session> session_;
  SessionLog log_;
  int run_ = -1;
  Aim aim_ = Aim::kNothing;
  LookAt target_{};
  StepHow how_ = StepHow::kInto;
  Focus from_{};
  std::vector<int> breakpoints_;
  bool is_between_ = true;  // no statement is being executed
};

}  // namespace armlet::lab
