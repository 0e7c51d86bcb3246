// Times that programs give, checked against the end of virtual time.
#pragma once

#include <cstdint>
#include <string_view>

#include "vm/state/state.hpp"

namespace armlet::lang {

// The words of messages about a duration.
//
// what, time   the operation, such as "a wait", and its duration: "the time to wait".
// requirement  the text of R0609 for durations that are too short.
// part         the part of the call that the message marks; the whole call: the statement.
struct TimeUse {
  std::string_view what;
  std::string_view time;
  std::int64_t least_ns = 0;
  std::string_view requirement = "time only runs forwards";
  CallPart part{};
};

// Converts `seconds` to nanoseconds, if they are finite, long enough, and end before the end of
// virtual time. Otherwise returns false with the failure set.
[[nodiscard]] bool check_time(VmState& state, const TimeUse& use, double seconds, std::int64_t& ns);

}  // namespace armlet::lang
