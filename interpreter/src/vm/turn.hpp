#pragma once
// One at a time: a Vm belongs to the thread that runs it, and to one call there.

#include "vm/state.hpp"

namespace armlet::lang {

// While it lives the program belongs to this thread: its functions can be called.
class Turn {
 public:
  // throws  ArgumentError if somebody else's has not ended.
  explicit Turn(VmState& state);
  ~Turn() { state_.thread.store(nullptr, std::memory_order_release); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  VmState& state_;
};

}  // namespace armlet::lang
