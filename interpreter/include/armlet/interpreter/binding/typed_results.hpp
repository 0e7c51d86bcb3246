#pragma once
// Results of `def` functions (define.hpp) as C++ types: double, std::int64_t, bool, std::string,
// std::vector<double>, a host type, std::vector of such references, Obj* (a new reference; null: it
// failed) and std::unique_ptr<Waiting> for an operation that takes time. Answer<T> is a result or a
// failure; void and Answer<void> have no result.

#include <memory>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "armlet/interpreter/answer.hpp"
#include "armlet/interpreter/binding/typed_parameters.hpp"

namespace armlet {

// Stores a result of type T in a slot: `kKind`, and leave(vm, value, slot), which may fail. This
// template is for the structs and classes that `type<T>` names.
template <class T>
struct Given {
  static_assert(std::is_class_v<T>, "no type of the language stands for this result");
  static constexpr ValueKind kKind{ValueKind::Form::kHost, false, typed::carried_type<T>()};
  static Signal leave(Vm& vm, T value, Slot& slot) {
    return give(&slot, new_host_value(vm, *kKind.host, std::move(value)));
  }
};

template <>
struct Given<void> {
  static constexpr ValueKind kKind{ValueKind::Form::kNothing};
};
template <class T>
requires SlotNumber<T>
struct Given<T> {
  static constexpr ValueKind kKind = Argument<T>::kKind;
  static Signal leave(Vm&, T value, Slot& slot) {
    slot = slot_of(value);
    return Signal::kDone;
  }
};
template <class T>
requires std::is_convertible_v<T, Obj*>
struct Given<T> {
  static constexpr ValueKind kKind{};
  static Signal leave(Vm&, Obj* object, Slot& slot) { return give(&slot, object); }
};
template <class T>
requires std::is_convertible_v<const T&, std::string_view>
struct Given<T> {
  static constexpr ValueKind kKind{ValueKind::Form::kText};
  static Signal leave(Vm& vm, std::string_view text, Slot& slot) {
    return give(&slot, new_text(vm, text));
  }
};
template <>
struct Given<std::vector<double>> {
  static constexpr ValueKind kKind{ValueKind::Form::kReals};
  static Signal leave(Vm& vm, std::span<const double> values, Slot& slot) {
    return give(&slot, new_reals(vm, values));
  }
};
template <HostValue T>
struct Given<T> {
  static constexpr ValueKind kKind = Argument<const T&>::kKind;
  static Signal leave(Vm& vm, T value, Slot& slot) {
    return give(&slot, new_host_value(vm, *kHostType<T>, std::move(value)));
  }
};
// A list of references, each stored like a single result.
template <class T>
struct Given<std::vector<T>> {
  static constexpr ValueKind kKind{Given<T>::kKind.form == ValueKind::Form::kHost
                                       ? ValueKind::Form::kHosts
                                       : ValueKind::Form::kItems,
                                   false, Given<T>::kKind.host};
  static Signal leave(Vm& vm, std::vector<T> values, Slot& slot) {
    ListObj* list = new_list(vm, static_cast<std::uint32_t>(values.size()), true);
    for (std::size_t i = 0; list != nullptr && i < values.size(); ++i) {
      if (Given<T>::leave(vm, std::move(values[i]), list->data[i]) == Signal::kDone) continue;
      release(vm, list);
      list = nullptr;
    }
    return give(&slot, list);
  }
};
// An operation that takes time. If it is over at once, its result is stored; otherwise the program
// waits.
template <>
struct Given<std::unique_ptr<Waiting>> {
  static constexpr ValueKind kKind{};
  static Signal leave(Vm& vm, std::unique_ptr<Waiting> waiting, Slot& slot) {
    return waiting->is_over() ? waiting->finish(vm, slot) : pause(vm, std::move(waiting));
  }
};
template <class T>
struct Given<Answer<T>> {
  static constexpr ValueKind kKind = Given<T>::kKind;
  static Signal leave(Vm& vm, Answer<T> answer, Slot& slot) {
    if (!answer) return Signal::kFail;
    if constexpr (std::is_void_v<T>) {
      return Signal::kDone;
    } else {
      return Given<T>::leave(vm, *std::move(answer), slot);
    }
  }
};

}  // namespace armlet
