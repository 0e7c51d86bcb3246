#include "vm/turn.hpp"

#include "armlet/core/error.hpp"
#include "armlet/core/platform.hpp"

namespace armlet::lang {

namespace {

[[noreturn]] void refuse_turn(const void* other) {
  throw ArgumentError(other == this_thread()
                          ? "This Vm runs already: a function that it calls cannot run it."
                          : "This Vm runs already, in another thread.");
}

void take_plain_turn(Turns& turns) {
  const void* other = nullptr;
  if (!turns.plain.compare_exchange_strong(other, this_thread(), std::memory_order_acquire))
    refuse_turn(other);
  turns.is_plain = true;
  turns.runs.store(this_thread(), std::memory_order_relaxed);
}

}  // namespace

// Dekker's algorithm with the fence on one side. The owner stores that it is in, and looks whether
// it still is the owner. Who comes takes the ownership away, lets all threads come to a fence, and
// looks whether the owner is in: then all stays as it was. Nobody owns the Vm after that, because
// the former owner may be about to store, late, that it is in. Where there is no such fence it has
// no owner at all.
void take_turn(Turns& turns) {
  const void* const me = this_thread();
  if (turns.has_no_owner.load(std::memory_order_acquire)) return take_plain_turn(turns);
  {
    const std::lock_guard one_at_a_time(turns.changing_owner);
    const void* const former = turns.owner.load();
    if (former == me) {
      if (turns.owner_is_in.load()) refuse_turn(me);
      turns.owner_is_in.store(true);
      turns.runs.store(me, std::memory_order_relaxed);
      return;
    }
    if (!turns.has_no_owner.load() && former == nullptr && fence_other_threads()) {
      turns.owner_is_in.store(true);
      turns.owner.store(me);
      turns.runs.store(me, std::memory_order_relaxed);
      return;
    }
    if (former != nullptr) {
      turns.owner.store(nullptr);
      if (!fence_other_threads() || turns.owner_is_in.load(std::memory_order_acquire)) {
        turns.owner.store(former);
        refuse_turn(former);
      }
    }
    turns.has_no_owner.store(true, std::memory_order_release);
  }
  take_plain_turn(turns);
}

}  // namespace armlet::lang
