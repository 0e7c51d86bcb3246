#pragma once
// A lock for rarely used data that all threads of the process share.

#include <mutex>

namespace armlet {

// Waits until no other thread holds the lock. A fork waits as well, so that in the child, which has
// only the forking thread, the lock is free. Hold it briefly, and do not fork meanwhile.
[[nodiscard]] std::unique_lock<std::mutex> lock_over_forks();

}  // namespace armlet
