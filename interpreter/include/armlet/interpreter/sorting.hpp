#pragma once
// Sorting that a stop request can interrupt.

#include <algorithm>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include "armlet/interpreter/work.hpp"

namespace armlet {

// Compares texts by their bytes. A long comparison counts as work; a short one is counted by the
// sorting function, with its block.
class TextOrder {
 public:
  static constexpr unsigned kCost = 32;  // of a short comparison

  explicit TextOrder(Vm& vm) : vm_(&vm) {}

  [[nodiscard]] bool operator()(Slot a, Slot b) {
    const std::string_view left = text_value(a);
    const std::string_view right = text_value(b);
    const std::size_t common = std::min(left.size(), right.size());
    if (common <= kShort) {
      const int order = std::memcmp(left.data(), right.data(), common);
      return order != 0 ? order < 0 : left.size() < right.size();
    }
    int order = 0;
    const auto compare = [&](std::size_t begin, std::size_t end) {
      order = std::memcmp(left.data() + begin, right.data() + begin, end - begin);
      return order == 0;
    };
    if (stopped_ || (!in_blocks(*vm_, common, 1, compare) && order == 0)) {
      stopped_ = true;  // the result is not used any more
      return false;
    }
    return order != 0 ? order < 0 : left.size() < right.size();
  }
  [[nodiscard]] bool was_stopped() const { return stopped_; }

 private:
  static constexpr std::size_t kShort = 256;  // bytes

  Vm* vm_;
  bool stopped_ = false;
};

template <class Less>
[[nodiscard]] bool was_stopped(const Less& less) {
  if constexpr (requires { less.was_stopped(); }) {
    return less.was_stopped();
  } else {
    return false;
  }
}

// An order or its reverse. In both, equal elements keep their order.
template <class Less>
class InDirection {
 public:
  InDirection(Less less, bool descending) : less_(std::move(less)), descending_(descending) {}
  template <class T>
  [[nodiscard]] bool operator()(T a, T b) {
    return descending_ ? less_(b, a) : less_(a, b);
  }
  [[nodiscard]] bool was_stopped() const { return armlet::was_stopped(less_); }

 private:
  Less less_;
  bool descending_;
};

// Sorts by merging runs of doubling length (a stable merge sort). `room` has the length of `items`.
// `cost`: operations of one comparison. Returns false, with the failure set, if the program has to
// stop; the order of the items is then undefined.
template <class T, class Less>
[[nodiscard]] bool sort_stably(Vm& vm, std::span<T> items, std::span<T> room, Less& less,
                               unsigned cost = 8) {
  constexpr std::size_t kRun = 32;
  const std::size_t n = items.size();
  const auto insert = [&](std::size_t begin, std::size_t end) {
    for (std::size_t run = begin * kRun; run < std::min(n, end * kRun); run += kRun) {
      for (std::size_t i = run + 1; i < std::min(n, run + kRun); ++i) {
        const T item = items[i];
        std::size_t at = i;
        for (; at > run && less(item, items[at - 1]); --at) items[at] = items[at - 1];
        items[at] = item;
      }
    }
    return !was_stopped(less);
  };
  if (!in_blocks(vm, (n + kRun - 1) / kRun, kRun * kRun / 4 * cost, insert)) return false;
  std::span<T> from = items;
  std::span<T> to = room;
  for (std::size_t length = kRun; length < n; length *= 2) {
    // The state of the merge: the next element of each of the two current runs.
    std::size_t pair = 0;
    std::size_t left = 0;
    std::size_t right = std::min(n, length);
    const auto merge = [&](std::size_t begin, std::size_t end) {
      for (std::size_t at = begin; at < end; ++at) {
        const std::size_t middle = std::min(n, pair + length);
        const std::size_t last = std::min(n, pair + 2 * length);
        const bool take_right = right < last && (left == middle || less(from[right], from[left]));
        to[at] = take_right ? from[right++] : from[left++];
        if (left == middle && right == last) {
          pair = left = last;
          right = std::min(n, pair + length);
        }
      }
      return !was_stopped(less);
    };
    if (!in_blocks(vm, n, cost, merge)) return false;
    std::swap(from, to);
  }
  if (from.data() != items.data()) std::copy(from.begin(), from.end(), items.begin());
  return true;
}

// A new list of the sorted elements of a list; null if it failed.
template <class Less>
[[nodiscard]] ListObj* sorted_list(Vm& vm, const ListObj& of, Less less, unsigned cost = 8) {
  const std::span<const Slot> xs(of.data, of.size);
  const bool references = of.holds_references();
  const Scratch scratch(vm, 2 * xs.size() * sizeof(Slot));
  if (!scratch.granted()) return nullptr;
  std::vector<Slot> items(xs.size());
  std::vector<Slot> room(xs.size());
  const auto take = [&](std::size_t begin, std::size_t end) {
    std::copy(xs.begin() + static_cast<std::ptrdiff_t>(begin),
              xs.begin() + static_cast<std::ptrdiff_t>(end),
              items.begin() + static_cast<std::ptrdiff_t>(begin));
  };
  if (!in_blocks(vm, xs.size(), 4, take) ||
      !sort_stably(vm, std::span<Slot>(items), std::span<Slot>(room), less, cost)) {
    return nullptr;
  }
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(xs.size()), references);
  if (list == nullptr) return nullptr;
  const auto put = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      list->data[i] = items[i];
      if (references) retain(items[i].o);
    }
  };
  if (in_blocks(vm, xs.size(), 8, put)) return list;
  release(vm, list);
  return nullptr;
}

}  // namespace armlet
