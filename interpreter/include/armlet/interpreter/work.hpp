#pragma once
// Long work in native functions: it counts as steps, and ends when the program has to stop.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "armlet/interpreter/native.hpp"

namespace armlet {

// How many elementary operations, each about a nanosecond, count as one step of the program.
inline constexpr std::uint64_t kWorkPerStep = 256;
// Operations between two checks for stop requests: a fraction of a millisecond.
inline constexpr std::uint64_t kBlockWork = std::uint64_t{1} << 18U;

// Counts the steps for an amount of work, in operations; less than one step is free, because the
// call itself is counted. Called before the work. Returns false, with the failure set, if the
// program has to stop.
[[nodiscard]] inline bool charge_work(Vm& vm, std::uint64_t operations) {
  return operations < kWorkPerStep || charge_steps(vm, operations / kWorkPerStep);
}

// Calls f(begin, end) for the blocks of [0, count) one after the other, and counts each before. f
// may return bool: false ends the loop. `cost`: operations for each item, at least 1. Returns false
// if f did, or, with the failure set, if the program has to stop.
template <class F>
[[nodiscard]] bool in_blocks(Vm& vm, std::size_t count, unsigned cost, F f) {
  const std::size_t block = std::max<std::size_t>(1, kBlockWork / cost);
  for (std::size_t begin = 0; begin < count;) {
    const std::size_t end = count - begin > block ? begin + block : count;
    if (!charge_work(vm, std::uint64_t{end - begin} * cost)) return false;
    if constexpr (std::is_void_v<decltype(f(begin, end))>) {
      f(begin, end);
    } else {
      if (!f(begin, end)) return false;
    }
    begin = end;
  }
  return true;
}

// Makes a text from pieces. Every piece counts as work, and for the limit of the heap.
class TextMaker {
 public:
  explicit TextMaker(Vm& vm) : vm_(vm) {}
  ~TextMaker();
  TextMaker(const TextMaker&) = delete;
  TextMaker& operator=(const TextMaker&) = delete;

  // Returns false, with the failure set, if the heap is full or the program has to stop.
  [[nodiscard]] bool add(std::string_view piece);
  // The text; null, with the failure set, if there was a failure.
  [[nodiscard]] Obj* take();

 private:
  Vm& vm_;
  TextObj* text_ = nullptr;
  std::uint64_t work_ = 0;  // of short pieces, to be counted later
  bool failed_ = false;
};

// Makes a list of references element by element, and owns them.
class ListMaker {
 public:
  explicit ListMaker(Vm& vm) : vm_(vm) {}
  ~ListMaker();
  ListMaker(const ListMaker&) = delete;
  ListMaker& operator=(const ListMaker&) = delete;

  // Adds an object and takes over its count; null means a failure that is set. Returns false, with
  // the failure set, if that fails.
  [[nodiscard]] bool push(Obj* object);
  // The list; null, with the failure set, if there was a failure.
  [[nodiscard]] Obj* take();

 private:
  Vm& vm_;
  ListObj* list_ = nullptr;
  std::uint64_t work_ = 0;
};

// Finds `what` in `text` from byte `from` on; npos if it is not there. Counted as work. Returns
// false, with the failure set, if the program has to stop.
[[nodiscard]] bool find_text(Vm& vm, std::string_view text, std::string_view what, std::size_t from,
                             std::size_t& at);

}  // namespace armlet
