#include "armlet/interpreter/watchdog.hpp"

#include <utility>

namespace armlet {

Watchdog::Watchdog(Vm& vm, std::chrono::nanoseconds time)
    : Watchdog([&vm] { vm.cancel(); }, time) {}
Watchdog::Watchdog(std::atomic<bool>& flag, std::chrono::nanoseconds time)
    : Watchdog([&flag] { flag.store(true); }, time) {}

Watchdog::Watchdog(std::function<void()> bark, std::chrono::nanoseconds time)
    : thread_([this, bark = std::move(bark), deadline = std::chrono::steady_clock::now() + time] {
        std::unique_lock lock(mutex_);
        if (ended_.wait_until(lock, deadline, [this] { return end_; })) return;
        has_barked_.store(true);
        bark();
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
