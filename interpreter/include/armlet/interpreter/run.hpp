// How a program runs: its limits, how far it may go at a time, and how it has ended.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "armlet/interpreter/diagnostic.hpp"

namespace armlet {

// Virtual time ends a hundred years of 365.25 days after the start, ns; a host may let it end
// earlier.
inline constexpr std::int64_t kEndOfTime_ns = 100LL * 36525 * 86400 * 10'000'000;

struct RunLimits {
  std::uint64_t steps = 100'000'000;  // calls and backward jumps (ruling 9)
  std::uint64_t heap_bytes = 1ULL << 30U;
  std::uint32_t call_depth = 10'000;
  std::uint64_t output_bytes = 1ULL << 30U;
  std::int64_t time_ns = kEndOfTime_ns;  // the virtual time at which a run ends (ruling 48)
};

// How far a run may go before it returns to the host, which can let it go on later. Where it pauses
// changes nothing of what the program does.
//
// until_ns  a virtual time: everything that happens up to and including it happens. The world is
//           brought to it too.
// steps     of the program, as RunLimits counts them. Work that cannot be interrupted, such as a
//           function of the host or a condition, is finished, so a run may take some more.
// statements  that may begin, of all tasks together; for programs with markers
//             (CompileOptions::markers).
struct Budget {
  static constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

  std::optional<std::int64_t> until_ns{};
  std::uint64_t steps = kNoLimit;
  std::uint64_t statements = kNoLimit;
};

// A point of a run. Compiled as it may be, a program comes to it in the same state.
//
// steps  that the program has taken, with those of calls that a session keeps in its log; at one
//        virtual time they tell points apart.
struct Instant {
  std::int64_t t_ns = 0;
  std::uint64_t steps = 0;

  bool operator==(const Instant&) const = default;
  // Whether a run that has come to here has passed or stands at the other.
  [[nodiscard]] bool has_reached(const Instant& other) const {
    return t_ns >= other.t_ns && steps >= other.steps;
  }
};

// kPaused  the budget is used; the run can go on.
enum class Progress : std::uint8_t { kDone, kFailed, kCancelled, kPaused };

struct RunResult {
  Progress status = Progress::kDone;
  std::optional<Diagnostic> error;  // kFailed, kCancelled
  std::uint64_t steps = 0;          // so far, as Instant counts them
};

// A task that the host had started (host/tasks.hpp) has ended.
//
// variable  that holds the function it ran.
// failure   why it failed, or that it was cancelled; null: it is done.
struct TaskEnd {
  std::string_view variable;
  std::int64_t start_ns = 0;
  std::int64_t end_ns = 0;
  const Diagnostic* failure = nullptr;
};

}  // namespace armlet
