#pragma once
// A limit on the real time that a program may take.

#include <atomic>
#include <chrono>
#include <functional>

#include "armlet/core/platform.hpp"
#include "armlet/interpreter/host/vm.hpp"

namespace armlet {

// Cancels the Vm's program after the time has passed, counted from now, like Vm::cancel: the
// program sees no clock, and its finally blocks run. If it is destroyed before, it does nothing.
class Watchdog {
 public:
  Watchdog(Vm& vm, std::chrono::nanoseconds time);
  // Sets a flag in place of cancelling a Vm, such as CompileOptions::cancelled.
  Watchdog(std::atomic<bool>& flag, std::chrono::nanoseconds time);

  // Whether the time has passed.
  [[nodiscard]] bool has_barked() const { return has_barked_.load(); }

 private:
  Watchdog(std::function<void()> bark, std::chrono::nanoseconds time);

  std::atomic<bool> has_barked_{false};
  Alarm alarm_;
};

}  // namespace armlet
