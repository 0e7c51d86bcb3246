#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vm/failures/failures.hpp"

namespace armlet::lang {

// A vector whose memory counts for the limit of the heap.
template <class T>
class Counted {
 public:
  explicit Counted(VmState& state) : state_(state) {}
  ~Counted() { state_.heap.discharge(charged_); }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;

  // Returns false, with the failure set, if the heap is full.
  [[nodiscard]] bool push(const T& item) {
    return (items.size() < items.capacity() || grow()) && (items.push_back(item), true);
  }
  [[nodiscard]] bool resize(std::size_t size, const T& item) {
    if (!charge(size)) return false;
    items.assign(size, item);
    return true;
  }
  std::vector<T> items;

 private:
  bool charge(std::size_t capacity) {
    const std::uint64_t more = (capacity - items.capacity()) * sizeof(T);
    if (!state_.heap.charge(more)) return raise_out_of_memory(state_);
    charged_ += more;
    return true;
  }
  bool grow() {
    const std::size_t capacity = 2 * items.capacity() + 16;
    if (!charge(capacity)) return false;
    items.reserve(capacity);
    return true;
  }

  VmState& state_;
  std::uint64_t charged_ = 0;
};

}  // namespace armlet::lang
