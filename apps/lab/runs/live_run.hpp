#pragma once
// A run under way: a session that is let run in slices, and the record that it fills.

#include <cstdint>
#include <memory>
#include <string>

#include "record.hpp"

namespace armlet::lab {

// What ends a run that does not end by itself.
struct RunBounds {
  std::int64_t time_ns = 600'000'000'000;
  std::uint64_t steps = 500'000'000;
};

// How much is done at a time.
inline constexpr std::uint64_t kSliceSteps = 100'000;

// The options of every session of a laboratory: what `options` says, with markers and variables
// that can be looked at.
[[nodiscard]] SessionOptions session_options(SessionOptions options, const RunBounds& bounds);

// Why an input was refused.
struct InputFault {
  std::string why;
  std::optional<UnreachedGoal> unreached{};
};

class LiveRun {
 public:
  // The record and the files outlive it.
  LiveRun(const SessionOptions& options, const RunBounds& bounds, RunRecord& record,
          ShownFiles& files);

  // Whether the text can run; the messages are in session().problems().
  bool begin(const std::string& text, const std::string& name);

  // The run of a log up to a time, and then an input that makes it another one.
  void begin_fork(const SessionLog& log, std::int64_t t_ns, InputWhat input);
  // Does something to the run where it stands; it then goes on. Why not, if it is refused.
  [[nodiscard]] std::optional<InputFault> give(const InputWhat& input);
  // Whether a fork has come to its input, and why that was refused.
  [[nodiscard]] bool has_forked() const { return !fork_; }
  [[nodiscard]] const std::optional<InputFault>& fork_fault() const { return fork_fault_; }

  // Runs a slice. Returns whether there is more to do.
  bool advance();
  // Ends it here, as a limit does.
  void stop(std::string why);
  [[nodiscard]] bool is_over() const { return record_.state != RunState::kRunning; }

  [[nodiscard]] Session& session() { return *session_; }

 private:
  [[nodiscard]] std::int64_t now_ns() const;
  void come_to_end(Progress progress);
  void finish_record();
  void take_rows();
  void advance_fork();
  void run_slice();
  void take_figures();

  RunBounds bounds_;
  RunRecord& record_;
  Recording recording_;
  RunMarks marks_;
  std::unique_ptr<Session> session_;
  struct Fork {
    std::int64_t t_ns = 0;
    InputWhat input;
  };
  std::optional<Fork> fork_;  // to come
  std::optional<InputFault> fork_fault_;
};

}  // namespace armlet::lab
