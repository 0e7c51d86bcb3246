#include "vm/host/list_natives.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "armlet/interpreter/sorting.hpp"

namespace armlet::lang {
namespace {

Signal common_length(Vm& vm, Slot* args) {
  const std::size_t a = items_value(args[0]).size();
  const std::size_t b = items_value(args[1]).size();
  if (a == b) return give(args, static_cast<std::int64_t>(a));
  Failure failure;
  failure.headline = {"R0613", {std::to_string(a) + " and " + std::to_string(b) + " values"}};
  failure.why = "zip takes one element of each list at a time";
  return fail(vm, std::move(failure));
}

template <class Less>
struct ByKey {
  std::span<const Slot> keys;
  Less less;
  bool operator()(std::uint32_t a, std::uint32_t b) { return less(keys[a], keys[b]); }
  [[nodiscard]] bool was_stopped() const { return armlet::was_stopped(less); }
};

template <class Less>
Signal sorted(Vm& vm, Slot* args, Less less, unsigned cost = 16) {
  const auto xs = items_value(args[0]);
  const Scratch scratch(vm, 2 * xs.size() * sizeof(std::uint32_t));
  if (!scratch.granted()) return Signal::kFail;
  std::vector<std::uint32_t> order(xs.size());
  std::vector<std::uint32_t> room(xs.size());
  const auto number = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) order[i] = static_cast<std::uint32_t>(i);
  };
  const bool descending = args[2].i != 0;
  InDirection by_key(ByKey<Less>{items_value(args[1]), less}, descending);
  if (!in_blocks(vm, xs.size(), 4, number) ||
      !sort_stably(vm, std::span(order), std::span(room), by_key, cost)) {
    return Signal::kFail;
  }
  const bool references = static_cast<const ListObj*>(args[0].o)->holds_references();
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(xs.size()), references);
  if (list == nullptr) return Signal::kFail;
  const auto copy = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      list->data[i] = xs[order[i]];
      if (references) retain(list->data[i].o);
    }
  };
  if (in_blocks(vm, order.size(), 8, copy)) return give(args, list);
  release(vm, list);
  return Signal::kFail;
}

Signal sort_by_int(Vm& vm, Slot* args) {
  return sorted(vm, args, [](Slot a, Slot b) { return a.i < b.i; });
}

Signal sort_by_real(Vm& vm, Slot* args) {
  const auto keys = reals_value(args[1]);
  std::size_t bad = keys.size();
  const auto look = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && bad == keys.size(); ++i) {
      if (std::isnan(keys[i])) bad = i;
    }
    return bad == keys.size();
  };
  if (!in_blocks(vm, keys.size(), 2, look) && bad == keys.size()) return Signal::kFail;
  if (bad != keys.size()) {
    Failure failure;
    failure.headline = {"R0612", {"the key of element " + std::to_string(bad), "nan"}};
    failure.mark = CallPart::operand(1);
    return fail(vm, std::move(failure));
  }
  return sorted(vm, args, [](Slot a, Slot b) { return a.d < b.d; });
}

Signal sort_by_text(Vm& vm, Slot* args) {
  return sorted(vm, args, TextOrder(vm), TextOrder::kCost);
}

}  // namespace

const NativeFunction kCommonLength = {.name = "zip", .thunk = &common_length};
const NativeFunction kSortByInt = {.name = "sort", .thunk = &sort_by_int};
const NativeFunction kSortByReal = {.name = "sort", .thunk = &sort_by_real};
const NativeFunction kSortByText = {.name = "sort", .thunk = &sort_by_text};

}  // namespace armlet::lang
