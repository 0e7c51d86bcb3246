#pragma once
// Cancellation of the compiler by a host.

#include <atomic>

namespace armlet::lang {

// Thrown inside the compiler after the host has cancelled it; caught by the functions that hosts
// call.
struct Cancelled {};

inline void stop_if(const std::atomic<bool>* cancelled) {
  if (cancelled != nullptr && cancelled->load(std::memory_order_relaxed)) throw Cancelled{};
}

}  // namespace armlet::lang
