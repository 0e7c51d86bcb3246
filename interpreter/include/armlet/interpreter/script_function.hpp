#pragma once
// Calls of a program's functions by host functions, with the types of C++.

#include <cstdint>
#include <type_traits>

#include "armlet/interpreter/engine.hpp"

namespace armlet {

// A number as it lies in a slot: double, std::int64_t (int) or bool.
template <class T>
concept SlotNumber =
    std::is_same_v<T, double> || std::is_same_v<T, std::int64_t> || std::is_same_v<T, bool>;

template <SlotNumber T>
[[nodiscard]] T number_in(Slot slot) {
  if constexpr (std::is_same_v<T, double>) {
    return slot.d;
  } else if constexpr (std::is_same_v<T, bool>) {
    return slot.i != 0;
  } else {
    return slot.i;
  }
}

// The function value in an argument declared as, for example, fn(double, double) -> double, which
// is ScriptFunction<double(double, double)>. It is borrowed from the argument, and may not pause.
template <class Signature>
class ScriptFunction;

template <SlotNumber Result, SlotNumber... Arguments>
class ScriptFunction<Result(Arguments...)> {
 public:
  ScriptFunction(Vm& vm, Slot function) : call_(vm, function.o) {}

  // False: the call failed, and the failure is set in the Vm; the host function returns kFail then.
  [[nodiscard]] bool call(Result& result, Arguments... arguments) const {
    [[maybe_unused]] Slot* next = call_.window();
    ((*next++ = slot_of(arguments)), ...);
    const PreparedCall::Outcome outcome = call_.run();
    if (!outcome.done) return false;
    if constexpr (std::is_same_v<Result, double>) {
      result = outcome.result;
    } else {
      result = number_in<Result>(*call_.window());
    }
    return true;
  }

 private:
  PreparedCall call_;
};

}  // namespace armlet
