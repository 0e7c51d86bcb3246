#pragma once
// Calls of a program's functions by host functions, with C++ types.
//
// Misuse by a host throws an ArgumentError: a Vm without a program, a name that an engine has
// already, a call of a script function with a wrong count of arguments, from another thread or
// while no program runs. Inside a native function the exception becomes a failure of the program of
// the kind Host, like every exception of native functions. A build with ARMLET_CHECKED also checks
// that each result of a native function and each argument of Vm::call is set and of the declared
// kind.

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>

#include "armlet/interpreter/answer.hpp"
#include "armlet/interpreter/host/vm.hpp"

namespace armlet {

// A number in a slot: double, std::int64_t (int) or bool.
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

// throws  ArgumentError unless `function` is a function value with parameters and a result of these
//         kinds (int stands for an enum too).
void require_types(Vm& vm, const Obj* function, std::span<const Kind> parameters, Kind result);

template <SlotNumber T>
[[nodiscard]] constexpr Kind kind_of_number() {
  if constexpr (std::is_same_v<T, double>) return Kind::kReal;
  if constexpr (std::is_same_v<T, bool>) return Kind::kBool;
  return Kind::kInt;
}

// The function value in an argument declared as, for example, fn(double, double) -> double, which
// is ScriptFunction<double(double, double)>. It is borrowed from the argument, and must not pause.
template <class Signature>
class ScriptFunction;

template <SlotNumber Result, SlotNumber... Arguments>
class ScriptFunction<Result(Arguments...)> {
 public:
  // throws  ArgumentError if the value is not a function of these types.
  ScriptFunction(Vm& vm, Slot function) : call_(vm, function.o) {
    static constexpr std::array<Kind, sizeof...(Arguments)> kKinds{kind_of_number<Arguments>()...};
    require_types(vm, function.o, kKinds, kind_of_number<Result>());
  }

  [[nodiscard]] Answer<Result> operator()(Arguments... arguments) const {
    Result result{};
    if (!call(result, arguments...)) return Failed{};
    return result;
  }
  // Returns false if the call failed; the failure is set, and the host function has to return
  // kFail.
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
