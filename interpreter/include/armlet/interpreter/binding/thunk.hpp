#pragma once
// Native functions as the virtual machine calls them, and their results.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "armlet/interpreter/object.hpp"

namespace armlet {

class Vm;

// The result of a native function: it has stored its value in args[0]; it has failed, with the
// failure stored in the Vm; or it takes virtual time.
enum class Signal : std::uint8_t { kDone, kFail, kPause };

// The return value of `fail`, which converts to the result of any function that may fail. The
// failure is stored in the Vm.
struct [[nodiscard]] Failed {
  operator Signal() const { return Signal::kFail; }
  template <class T>
  operator std::optional<T>() const {
    return std::nullopt;
  }
};

// The code of a native function, which a program calls.
//
// args     one slot per parameter, then room for the result in args[0]. References in args are
//          borrowed; the caller owns a reference that is the result.
// closure  data that the function keeps between calls, which must outlive the engine; null if none.
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

// What happens at a block of a program. A function of the host runs at each of these events.
enum class BlockEvent : std::uint8_t {
  kNone,
  kWithBegins,  // `with`: its settings follow
  kWithEnds,    // at every exit of `with`: restores the former settings
  kPathBegins,  // `path`: its settings follow
  kPathMoves,   // at the end of `path` without an error: makes the moves that it has collected
  kPathEnds,    // at every exit of `path`
};
inline constexpr std::size_t kBlockEvents = 6;

// The kind of a parameter or result of a C++ function, for the comparison with its signature
// (define.hpp).
struct ValueKind {
  enum class Form : std::uint8_t {
    kAny,  // a slot without a conversion
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
    kHosts,  // a list of values of a host type
  };
  Form form = Form::kAny;
  bool optional = false;
  const HostType* host = nullptr;

  bool operator==(const ValueKind&) const = default;
};

}  // namespace armlet
