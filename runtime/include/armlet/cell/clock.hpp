#pragma once

#include <cstdint>
#include <functional>

namespace armlet {

inline constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

// The nearest whole number of nanoseconds.
// throws  ArgumentError for a negative time and one beyond 100 years.
std::int64_t to_ns(double seconds);
double to_seconds(std::int64_t t_ns);

// Waits until wall-clock time has reached virtual time t_ns, for hosts that show a run at its
// speed.
using Pacer = std::function<void(std::int64_t t_ns)>;

// Virtual time of a run: whole nanoseconds from 0. It never decreases and does not depend on a wall
// clock.
class Clock {
 public:
  [[nodiscard]] std::int64_t now_ns() const { return now_ns_; }

  // The pacer is called before every step forward; it cannot change the run. Null: full speed.
  void set_pacer(Pacer pacer) { pacer_ = std::move(pacer); }

  // Throws ArgumentError if t_ns is in the past.
  void advance_to(std::int64_t t_ns);

 private:
  std::int64_t now_ns_ = 0;
  Pacer pacer_;
};

}  // namespace armlet
