#pragma once
// Converts values of the program into values of a host, and back.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "armlet/interpreter/host/value.hpp"
#include "base/utf8.hpp"
#include "vm/state/state.hpp"

namespace armlet::lang {

// throws  ArgumentError, which begins with `what`, if a part cannot be a value of a host: a
//         function, or an element without a value.
[[nodiscard]] Value value_in(Slot slot, const Type& type, const std::string& what);

// Whether a value may contain NaN. Values that a program computes may; values that a host passes in
// may not, because their origin would be hard to find later. Infinite numbers are allowed.
enum class Undefined : std::uint8_t { kRefused, kKept };

// The end of a message that begins with "takes a speed".
inline constexpr const char* kUndefinedNumber =
    ", and was given nan; any number will do, also an infinite one";

[[nodiscard]] std::string broken_text(std::size_t byte);  // "takes a string, and was given ..."

// A new slot that owns the value, converted to the type.
//
// throws  ArgumentError, which begins with the name of the part after `what`, if a part has another
//         type or is NaN, and if the heap is full.
[[nodiscard]] Slot slot_of_value(VmState& state, const Value& value, const Type& type,
                                 const std::string& what,
                                 Undefined undefined = Undefined::kRefused);

// Whether types of two programs are the same: equal names, fields, units and parameters.
[[nodiscard]] bool is_same_type(const Type& a, const Type& b);

}  // namespace armlet::lang
