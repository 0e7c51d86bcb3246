#pragma once
// Loops over list elements and numbers, in blocks whose work is charged.

#include <fmt/format.h>

#include <cstdint>
#include <span>

#include "armlet/interpreter/work.hpp"
#include "values/bind.hpp"

namespace armlet::bind {

// Operations charged for reading, computing and writing an element that is cheap to compute.
inline constexpr unsigned kCost = 4;
// Operations charged for an element if a function such as the sine is computed, or a number is
// converted to text.
inline constexpr unsigned kFunctionCost = 32;

// A new list of `count` elements, each set by make(slot, i); reference counts are updated here.
// Null: it failed.
template <class F>
[[nodiscard]] ListObj* list_of(Vm& vm, std::size_t count, bool references, F make,
                               unsigned cost = kCost) {
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(count), references);
  if (list == nullptr) return nullptr;
  const auto fill = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      make(list->data[i], i);
      if (references) retain(list->data[i].o);
    }
  };
  if (in_blocks(vm, count, references ? cost + 4 : cost, fill)) return list;
  release(vm, list);
  return nullptr;
}

// A new list of numbers, each set by make(slot, i); numbers have no reference counts.
template <class F>
[[nodiscard]] ListObj* numbers_of(Vm& vm, std::size_t count, F make, unsigned cost = kCost) {
  return list_of(vm, count, false, make, cost);
}

// A new list of numbers that set(slot, i) computes; set may fail.
template <class F>
[[nodiscard]] ListObj* checked_items(Vm& vm, std::size_t count, unsigned cost, F set) {
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(count), false);
  if (list == nullptr) return nullptr;
  const auto fill = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!set(list->data[i], i)) return false;
    }
    return true;
  };
  if (in_blocks(vm, count, cost, fill)) return list;
  release(vm, list);
  return nullptr;
}

// Finds the first number with `is_wanted`; `at` is unchanged if there is none. False: the program
// must stop, and the failure is set.
template <class F>
[[nodiscard]] bool find_number(Vm& vm, std::span<const double> xs, std::size_t& at, F is_wanted) {
  bool found = false;
  const auto look = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !found; ++i) {
      found = is_wanted(xs[i]);
      if (found) at = i;
    }
    return !found;
  };
  return in_blocks(vm, xs.size(), kCost, look) || found;
}

// The index of the first largest (kMax) or smallest element, among ints or doubles that are all
// defined.
template <bool kMax, class Number>
Answer<std::int64_t> index_of_extreme(Vm& vm, std::span<const Slot> xs) {
  if (xs.empty())
    return failure(vm, "R0613",
                   fmt::format("an empty list has no {} value", kMax ? "largest" : "smallest"),
                   CallPart::first());
  const auto number = [xs](std::size_t i) { return number_in<Number>(xs[i]); };
  std::size_t best = 0;
  std::size_t bad = xs.size();
  const auto look = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && bad == xs.size(); ++i) {
      if (number(i) != number(i)) bad = i;
      if (kMax ? number(i) > number(best) : number(i) < number(best)) best = i;
    }
    return bad == xs.size();
  };
  const bool done = in_blocks(vm, xs.size(), kCost, look);
  if (bad != xs.size())
    return not_finite(vm, fmt::format("element {} of the list", bad), xs[bad].d, CallPart::first());
  if (!done) return Failed{};
  return static_cast<std::int64_t>(best);
}

}  // namespace armlet::bind
