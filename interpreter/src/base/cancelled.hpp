#pragma once
// How a host stops the compiler.

#include <atomic>

namespace armlet::lang {

// Thrown where the work is noticed to be no longer wanted; caught at the door of the compiler.
struct Cancelled {};

inline void stop_if(const std::atomic<bool>* cancelled) {
  if (cancelled != nullptr && cancelled->load(std::memory_order_relaxed)) throw Cancelled{};
}

}  // namespace armlet::lang
