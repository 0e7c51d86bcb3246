// Runs of a program: their limits, their slices, and their results.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "armlet/interpreter/diagnostic.hpp"

namespace armlet {

// The end of virtual time, ns: a hundred years of 365.25 days after the start. A host may set an
// earlier one.
inline constexpr std::int64_t kEndOfTime_ns = 100LL * 36525 * 86400 * 10'000'000;

struct RunLimits {
  std::uint64_t steps = 100'000'000;  // calls and backward jumps
  std::uint64_t heap_bytes = 1ULL << 30U;
  std::uint32_t call_depth = 10'000;
  std::uint64_t output_bytes = 1ULL << 30U;
  std::int64_t time_ns = kEndOfTime_ns;  // the virtual time at which a run ends
};

// The limits of a slice: how far a run may go before it returns to the host, which can continue it.
// The pauses have no influence on the program.
//
// until_ns    a virtual time: everything up to and including it happens, and the world is at it.
// steps       of the program, as RunLimits counts them. Work that cannot be interrupted, such as a
//             host function or a condition, is completed, so a run may take more steps.
// statements  that may begin, of all tasks together; for programs with markers
//             (CompileOptions::markers).
struct Budget {
  static constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

  std::optional<std::int64_t> until_ns{};
  std::uint64_t steps = kNoLimit;
  std::uint64_t statements = kNoLimit;
};

// A point of a run. The program has the same state there, whatever options it was compiled with.
//
// steps  of the program, with those of calls that a session keeps in its log. They order the points
//        with the same virtual time.
struct Instant {
  std::int64_t t_ns = 0;
  std::uint64_t steps = 0;

  bool operator==(const Instant&) const = default;
  // Whether a run at this point has reached or passed the other one.
  [[nodiscard]] bool has_reached(const Instant& other) const {
    return t_ns >= other.t_ns && steps >= other.steps;
  }
};

// kPaused  the budget is used up; the run can continue.
enum class Progress : std::uint8_t { kDone, kFailed, kCancelled, kPaused };

struct RunResult {
  Progress status = Progress::kDone;
  std::optional<Diagnostic> error;  // kFailed, kCancelled
  std::uint64_t steps = 0;          // so far, as Instant counts them
};

// The end of a task that the host has started (host/tasks.hpp).
//
// variable  the variable with its function.
// failure   its failure, or that it was cancelled; null: it has completed.
struct TaskEnd {
  std::string_view variable;
  std::int64_t start_ns = 0;
  std::int64_t end_ns = 0;
  const Diagnostic* failure = nullptr;
};

}  // namespace armlet
