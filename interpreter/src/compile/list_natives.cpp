#include "compile/list_natives.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace armlet::lang {
namespace {

Signal common_length(Vm& vm, Slot* args) {
  const std::size_t a = items_value(args[0]).size();
  const std::size_t b = items_value(args[1]).size();
  if (a == b) return give(args, static_cast<std::int64_t>(a));
  Failure failure;
  failure.code = "R0613";
  failure.arguments = {std::to_string(a) + " and " + std::to_string(b) + " values"};
  failure.why = "zip takes one element of each list at a time";
  return fail(vm, std::move(failure));
}

template <class Less>
Signal sorted(Vm& vm, Slot* args, Less less) {
  const auto xs = items_value(args[0]);
  const auto keys = items_value(args[1]);
  std::vector<std::uint32_t> order(xs.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return less(keys[a], keys[b]); });
  const bool references = static_cast<const ListObj*>(args[0].o)->holds_references();
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(xs.size()), references);
  if (list == nullptr) return Signal::kFail;
  for (std::size_t i = 0; i < order.size(); ++i) {
    list->data[i] = xs[order[i]];
    if (references) retain(list->data[i].o);
  }
  return give(args, list);
}

Signal sort_by_int(Vm& vm, Slot* args) {
  return sorted(vm, args, [](Slot a, Slot b) { return a.i < b.i; });
}

Signal sort_by_real(Vm& vm, Slot* args) {
  const auto keys = reals_value(args[1]);
  const auto bad = std::ranges::find_if(keys, [](double x) { return std::isnan(x); });
  if (bad != keys.end()) {
    Failure failure;
    failure.code = "R0612";
    failure.arguments = {"the key of element " + std::to_string(bad - keys.begin()), "nan"};
    failure.mark_parameter = 1;
    return fail(vm, std::move(failure));
  }
  return sorted(vm, args, [](Slot a, Slot b) { return a.d < b.d; });
}

Signal sort_by_text(Vm& vm, Slot* args) {
  return sorted(vm, args, [](Slot a, Slot b) { return text_value(a) < text_value(b); });
}

}  // namespace

const NativeFunction kCommonLength = {.name = "zip", .thunk = &common_length};
const NativeFunction kSortByInt = {.name = "sort", .thunk = &sort_by_int};
const NativeFunction kSortByReal = {.name = "sort", .thunk = &sort_by_real};
const NativeFunction kSortByText = {.name = "sort", .thunk = &sort_by_text};

}  // namespace armlet::lang
