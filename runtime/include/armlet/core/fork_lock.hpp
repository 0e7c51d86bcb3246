#pragma once
// A lock for what all threads of the process share and seldom use.

#include <mutex>

namespace armlet {

// Waits until no other thread holds it. A fork waits as well, so that the child, which has only the
// thread that forked, finds the lock free: hold it briefly, and do not fork while you do.
[[nodiscard]] std::unique_lock<std::mutex> lock_over_forks();

}  // namespace armlet
