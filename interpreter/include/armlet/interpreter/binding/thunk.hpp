#pragma once
// What runs when a program calls a native function, and what it tells the machine.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "armlet/interpreter/object.hpp"

namespace armlet {

class Vm;

// What a native function did: left its result in args[0]; failed (the failure is in the Vm); or
// takes virtual time.
enum class Signal : std::uint8_t { kDone, kFail, kPause };

// What `fail` gives: the failure is in the Vm. It stands for the result of any function that may
// fail.
struct [[nodiscard]] Failed {
  operator Signal() const { return Signal::kFail; }
  template <class T>
  operator std::optional<T>() const {
    return std::nullopt;
  }
};

// What runs when a program calls a native function.
//
// args: one slot per parameter, then room for the result in args[0]. References in args are
// borrowed; a reference left as the result belongs to the caller.
// closure: what the function keeps between calls, which outlives the engine; null if it keeps
// nothing.
class Thunk {
 public:
  using Plain = Signal (*)(Vm& vm, Slot* args);
  using Bound = Signal (*)(Vm& vm, Slot* args, const void* closure);

  constexpr Thunk(std::nullptr_t = nullptr) {}
  constexpr Thunk(Plain function) : plain_(function) {}
  template <class Lambda>
  requires std::convertible_to<Lambda, Plain>
  constexpr Thunk(Lambda function) : plain_(function) {}
  constexpr Thunk(Bound function, const void* closure) : bound_(function), closure_(closure) {}

  Signal operator()(Vm& vm, Slot* args) const {
    return bound_ == nullptr ? plain_(vm, args) : bound_(vm, args, closure_);
  }
  constexpr bool operator==(const Thunk&) const = default;
  [[nodiscard]] constexpr explicit operator bool() const {
    return plain_ != nullptr || bound_ != nullptr;
  }

 private:
  Plain plain_ = nullptr;
  Bound bound_ = nullptr;
  const void* closure_ = nullptr;
};

// What a parameter or result of a function in C++ is, to be compared with its signature
// (define.hpp).
struct ValueKind {
  enum class Form : std::uint8_t {
    kAny,  // a slot as it lies
    kNothing,
    kBool,
    kInt,
    kReal,
    kText,
    kReals,  // a list of doubles or quantities
    kItems,  // any list, as slots
    kMatrix,
    kRecord,  // a struct, a record of the library or a table
    kFunction,
    kHost,
    kHosts,  // a list of them
  };
  Form form = Form::kAny;
  bool optional = false;
  const HostType* host = nullptr;

  bool operator==(const ValueKind&) const = default;
};

}  // namespace armlet
