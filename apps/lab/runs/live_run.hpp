#pragma once
// A running run: a session that runs in slices, and the record that it fills.

#include <cstdint>
#include <memory>
#include <string>

#include "record.hpp"

namespace armlet::lab {

// The limits for a run that does not end by itself.
struct RunBounds {
  std::int64_t time_ns = 600'000'000'000;
  std::uint64_t steps = 500'000'000;
};

// The number of steps of a slice.
inline constexpr std::uint64_t kSliceSteps = 100'000;

// The options of every session of a laboratory: `options` with markers, and with variables that can
// be read.
[[nodiscard]] SessionOptions session_options(SessionOptions options, const RunBounds& bounds);

// The reason why an input was refused.
struct InputFault {
  std::string why;
  std::optional<UnreachedGoal> unreached{};
};

class LiveRun {
 public:
  // The record and the files must outlive it.
  LiveRun(const SessionOptions& options, const RunBounds& bounds, RunRecord& record,
          ShownFiles& files);

  // Returns whether the text can run; the messages are in session().problems().
  bool begin(const std::string& text, const std::string& name);

  // Replays the run of a log up to a time, and then applies an input that makes it another run.
  void begin_fork(const SessionLog& log, std::int64_t t_ns, InputWhat input);
  // Applies an input at the present instant; the run then continues. Returns the reason if refused.
  [[nodiscard]] std::optional<InputFault> give(const InputWhat& input);
  // Whether a fork has reached its input, and why that was refused.
  [[nodiscard]] bool has_forked() const { return !fork_; }
  [[nodiscard]] const std::optional<InputFault>& fork_fault() const { return fork_fault_; }

  // Runs a slice. Returns whether there is more to do.
  bool advance();
  // Ends the run here, as a limit does.
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
  std::optional<Fork> fork_;  // not reached yet
  std::optional<InputFault> fork_fault_;
};

}  // namespace armlet::lab
