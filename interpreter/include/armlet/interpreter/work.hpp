#pragma once
// Long work inside native functions: counted as steps, and stopped when the program has to stop.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "armlet/interpreter/native.hpp"

namespace armlet {

// How many elementary operations, each about a nanosecond, count as one step of the program.
inline constexpr std::uint64_t kWorkPerStep = 256;
// Work that is done without a look at the wish to cancel: a fraction of a millisecond.
inline constexpr std::uint64_t kBlockWork = std::uint64_t{1} << 18U;

// Counts steps for so many operations; less than one step is free, since the call itself was
// counted. Ask before the work. False: the program has to stop and the failure is set.
[[nodiscard]] inline bool charge_work(Vm& vm, std::uint64_t operations) {
  return operations < kWorkPerStep || charge_steps(vm, operations / kWorkPerStep);
}

// f(begin, end) for the blocks of [0, count) one after the other, each counted before it is done.
// f may give bool: false ends it. `cost`: operations for each item, at least 1.
// False: f was false, or the program has to stop and the failure is set.
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

// A text made piece by piece: every piece counts as work and against the heap limit.
class TextMaker {
 public:
  explicit TextMaker(Vm& vm) : vm_(vm) {}
  ~TextMaker();
  TextMaker(const TextMaker&) = delete;
  TextMaker& operator=(const TextMaker&) = delete;

  // False: the heap is full or the program has to stop; the failure is set.
  [[nodiscard]] bool add(std::string_view piece);
  // The text; null if there was a failure, which is set.
  [[nodiscard]] Obj* take();

 private:
  Vm& vm_;
  TextObj* text_ = nullptr;
  std::uint64_t work_ = 0;  // of short pieces, not counted yet
  bool failed_ = false;
};

// A list of references made element by element; it owns them.
class ListMaker {
 public:
  explicit ListMaker(Vm& vm) : vm_(vm) {}
  ~ListMaker();
  ListMaker(const ListMaker&) = delete;
  ListMaker& operator=(const ListMaker&) = delete;

  // Takes over the object; null is a failure that is set. False: the failure is set.
  [[nodiscard]] bool push(Obj* object);
  // The list; null if there was a failure, which is set.
  [[nodiscard]] Obj* take();

 private:
  Vm& vm_;
  ListObj* list_ = nullptr;
  std::uint64_t work_ = 0;
};

// Whether `what` stands in `text` at or behind byte `from`, and where; npos: no. Counted as work.
// False: the program has to stop and the failure is set.
[[nodiscard]] bool find_text(Vm& vm, std::string_view text, std::string_view what, std::size_t from,
                             std::size_t& at);

}  // namespace armlet
