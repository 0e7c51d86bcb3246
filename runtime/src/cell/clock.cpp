#include "armlet/cell/clock.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/error.hpp"

namespace armlet {

std::int64_t to_ns(double seconds) {
  constexpr double kLongest = 100.0 * 366.0 * 86400.0;
  if (!(seconds >= 0.0 && seconds <= kLongest)) {
    throw ArgumentError(
        fmt::format("A time of {} s cannot be used; expected 0 s to 100 years.", seconds));
  }
  return std::llround(seconds * static_cast<double>(kNanosecondsPerSecond));
}

double to_seconds(std::int64_t t_ns) {
  return static_cast<double>(t_ns) / static_cast<double>(kNanosecondsPerSecond);
}

void Clock::advance_to(std::int64_t t_ns) {
  if (t_ns < now_ns_) {
    throw ArgumentError(
        fmt::format("The clock cannot go back from {} ns to {} ns.", now_ns_, t_ns));
  }
  if (t_ns > now_ns_ && pacer_) pacer_(t_ns);
  now_ns_ = t_ns;
}

}  // namespace armlet
