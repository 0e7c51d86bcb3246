#pragma once
// Calls of a program's functions by host functions, with the types of C++.
//
// What a host does wrong is an ArgumentError: a Vm without a program, a name that an engine knows
// already, a function of the program called with another number of arguments, from another thread
// or when nothing runs. Inside a native function that is a failure of the program, like everything
// that native functions throw: its kind is Host. A build with ARMLET_CHECKED also looks at each
// result of a native function and at each argument of Vm::call: whether it has been set, and is of
// the declared kind.

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>

#include "armlet/interpreter/answer.hpp"
#include "armlet/interpreter/host/vm.hpp"

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

// throws  ArgumentError unless that is a function value with parameters and a result of these kinds
//         (int stands for an enum too).
void require_types(Vm& vm, const Obj* function, std::span<const Kind> parameters, Kind result);

template <SlotNumber T>
[[nodiscard]] constexpr Kind kind_of_number() {
  if constexpr (std::is_same_v<T, double>) return Kind::kReal;
  if constexpr (std::is_same_v<T, bool>) return Kind::kBool;
  return Kind::kInt;
}

// The function value in an argument declared as, for example, fn(double, double) -> double, which
// is ScriptFunction<double(double, double)>. It is borrowed from the argument, and may not pause.
template <class Signature>
class ScriptFunction;

template <SlotNumber Result, SlotNumber... Arguments>
class ScriptFunction<Result(Arguments...)> {
 public:
  // throws  ArgumentError if that is no function value of these types.
  ScriptFunction(Vm& vm, Slot function) : call_(vm, function.o) {
    static constexpr std::array<Kind, sizeof...(Arguments)> kKinds{kind_of_number<Arguments>()...};
    require_types(vm, function.o, kKinds, kind_of_number<Result>());
  }

  [[nodiscard]] Answer<Result> operator()(Arguments... arguments) const {
    Result result{};
    if (!call(result, arguments...)) return Failed{};
    return result;
  }
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
