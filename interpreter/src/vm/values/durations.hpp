// Times that programs give, checked against the end of virtual time.
#pragma once

#include <cstdint>
#include <string_view>

#include "vm/state/state.hpp"

namespace armlet::lang {

// What a time is for, in messages.
//
// what, time   "a wait", and its time: "the time to wait".
// requirement  what R0609 says of times that are too short.
// parameter    of the function that is marked; -1: the statement is.
struct TimeUse {
  std::string_view what;
  std::string_view time;
  std::int64_t least_ns = 0;
  std::string_view requirement = "time only runs forwards";
  int parameter = -1;
};

// `seconds` in nanoseconds if it is finite, long enough, and over before virtual time ends;
// otherwise the failure is set.
[[nodiscard]] bool check_time(VmState& state, const TimeUse& use, double seconds, std::int64_t& ns);

}  // namespace armlet::lang
