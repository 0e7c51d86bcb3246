#include "armlet/interpreter/host/watchdog.hpp"

#include <utility>

namespace armlet {

Watchdog::Watchdog(Vm& vm, std::chrono::nanoseconds time)
    : Watchdog([&vm] { vm.cancel(); }, time) {}
Watchdog::Watchdog(std::atomic<bool>& flag, std::chrono::nanoseconds time)
    : Watchdog([&flag] { flag.store(true); }, time) {}

Watchdog::Watchdog(std::function<void()> bark, std::chrono::nanoseconds time)
    : alarm_(time.count(), [this, bark = std::move(bark)] {
        has_barked_.store(true);
        bark();
      }) {}

}  // namespace armlet
