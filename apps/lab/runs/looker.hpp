#pragma once
// Looks into a run at an instant: takes the run once more, unheard, until it is there.

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

// What there is at an instant of a run.
//
// line, span  of the statement that has begun last or is about to begin; 0: none has.
// statements  that have begun.
struct SeenInstant {
  // scope  0: the top level; then the calls of the task, from outside to inside.
  // value  nothing: it has none yet.
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

// Where a run is to be looked at: after everything that happens until a time, or where so many
// statements have begun and the next one has not.
struct LookAt {
  std::int64_t t_ns = 0;
  std::optional<std::uint64_t> statements{};
  bool operator==(const LookAt&) const = default;
};

// One at a time: a new place replaces the one before.
class Looker {
 public:
  explicit Looker(SessionOptions options);
  ~Looker();

  // Begins to go to a place of the run with this number and log. From a place before it in the same
  // run it goes on.
  void go_to(int run, const SessionLog& log, LookAt place);
  // Begins a step from where it is; breakpoints end it as well.
  void step(StepHow how, const std::vector<int>& breakpoints);
  // Goes on for a while. Returns whether there is more to do.
  bool advance();
  [[nodiscard]] bool is_under_way() const { return aim_ != Aim::kNothing; }
  [[nodiscard]] bool is_at(int run) const { return session_ != nullptr && run_ == run; }

  [[nodiscard]] SeenInstant look();
  // Where it is now, to come back to.
  [[nodiscard]] LookAt place();
  // Forgets the run, whose log has become another one.
  void forget();
  // Of the run that is looked at; there is one after go_to.
  [[nodiscard]] Session& session() { return *session_; }
  [[nodiscard]] bool was_cancelled() const {
    return session_ != nullptr && session_->result().status == Progress::kCancelled;
  }

 private:
  // kStatement: to the end of the statement in whose middle it is.
  enum class Aim : std::uint8_t { kNothing, kTime, kStatements, kStatement, kStep, kBreakpoint };
  struct Focus {
    std::string task;
    std::size_t depth = 0;
    Span at{};
  };

  void restart(const SessionLog& log);
  bool run_slice(Budget budget);
  [[nodiscard]] bool has_ended() const;
  // Whether nothing happens any more: it has ended, or waits for an input.
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
  bool is_between_ = true;  // statements: none is under way where it stands
};

}  // namespace armlet::lab
