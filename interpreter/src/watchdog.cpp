#include "armlet/interpreter/watchdog.hpp"

namespace armlet {

Watchdog::Watchdog(Vm& vm, std::chrono::nanoseconds time)
    : thread_([this, &vm, deadline = std::chrono::steady_clock::now() + time] {
        std::unique_lock lock(mutex_);
        if (ended_.wait_until(lock, deadline, [this] { return end_; })) return;
        has_barked_.store(true);
        vm.cancel();
      }) {}

Watchdog::~Watchdog() {
  {
    const std::scoped_lock lock(mutex_);
    end_ = true;
  }
  ended_.notify_all();
  thread_.join();
}

}  // namespace armlet
