#include "armlet/model/derived_values.hpp"

#include <atomic>
#include <mutex>
#include <utility>

namespace armlet {

// An append-only list of slots, so that searching it needs no lock. It has one slot for each
// requested type, which are few.
struct DerivedValues::Slots {
  struct Slot {
    explicit Slot(const void* type) : key(type) {}

    const void* const key;
    std::atomic<const void*> value = nullptr;  // null until it is made
    std::mutex making;
    std::shared_ptr<const void> owner;
    std::unique_ptr<Slot> next;  // set before others can see the slot
  };

  std::atomic<Slot*> first = nullptr;
  std::mutex adding;
  std::unique_ptr<Slot> list;

  Slot* look_for(const void* key) const {
    Slot* slot = first.load(std::memory_order_acquire);
    while (slot != nullptr && slot->key != key) slot = slot->next.get();
    return slot;
  }

  Slot& add(const void* key) {
    const std::lock_guard lock(adding);
    if (Slot* slot = look_for(key)) return *slot;
    auto slot = std::make_unique<Slot>(key);
    slot->next = std::move(list);
    list = std::move(slot);
    first.store(list.get(), std::memory_order_release);
    return *list;
  }
};

DerivedValues::DerivedValues() : slots_(std::make_shared<Slots>()) {}

// Each slot has its own lock: while its value is made, values of other types are available.
const void* DerivedValues::find(const void* key, Make* make, const void* source) const {
  Slots::Slot* found = slots_->look_for(key);
  if (found != nullptr) {
    if (const void* value = found->value.load(std::memory_order_acquire)) return value;
  }
  Slots::Slot& slot = found != nullptr ? *found : slots_->add(key);
  const std::lock_guard lock(slot.making);
  if (slot.owner == nullptr) {
    slot.owner = make(source);
    slot.value.store(slot.owner.get(), std::memory_order_release);
  }
  return slot.owner.get();
}

}  // namespace armlet
