#include "vm/state/turn.hpp"

#include "armlet/core/error.hpp"

namespace armlet::lang {

void refuse_turn(const void* other) {
  throw ArgumentError(other == this_thread()
                          ? "This Vm runs already: a function that it calls cannot run it."
                          : "This Vm runs already, in another thread.");
}

}  // namespace armlet::lang
