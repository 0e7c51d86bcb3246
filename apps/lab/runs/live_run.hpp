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
inline constexpr std::int64_t kSlice_ns = 2'000'000'000;
inline constexpr std::uint64_t kSliceSteps = 100'000;

// The options of every session of a laboratory: what `options` says, with markers and variables
// that can be looked at.
[[nodiscard]] SessionOptions session_options(SessionOptions options, const RunBounds& bounds);

class LiveRun {
 public:
  // The record outlives it.
  LiveRun(const SessionOptions& options, const RunBounds& bounds, RunRecord& record);

  // Whether the text can run; the messages are in session().problems().
  bool begin(const std::string& text, const std::string& name);

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
  void take_figures();

  RunBounds bounds_;
  RunRecord& record_;
  Recording recording_;
  RunMarks marks_;
  std::unique_ptr<Session> session_;
};

}  // namespace armlet::lab
