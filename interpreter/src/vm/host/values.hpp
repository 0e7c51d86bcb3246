#pragma once
// Values of the program into those that a host owns, and back.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "armlet/interpreter/host/value.hpp"
#include "base/utf8.hpp"
#include "vm/state/state.hpp"

namespace armlet::lang {

// throws  ArgumentError, which begins with `what`, if there is a part that no host can hold: a
//         function, or an element without a value.
[[nodiscard]] Value value_in(Slot slot, const Type& type, const std::string& what);

// What a program computes may be NaN. What comes from outside may not: where it comes from would be
// found nowhere. It may be infinite, as in programs.
enum class Undefined : std::uint8_t { kRefused, kKept };

// Behind "takes a speed".
inline constexpr const char* kUndefinedNumber =
    ", and was given nan; any number will do, also an infinite one";

[[nodiscard]] std::string broken_text(std::size_t byte);  // "takes a string, and was given ..."

// A slot that owns its value, which has the type.
//
// throws  ArgumentError, which begins with the part of `what`, if that is of another type or NaN,
//         and if the heap is full.
[[nodiscard]] Slot slot_of_value(VmState& state, const Value& value, const Type& type,
                                 const std::string& what,
                                 Undefined undefined = Undefined::kRefused);

// Whether types of two programs mean the same: equal names, fields, units and so on.
[[nodiscard]] bool is_same_type(const Type& a, const Type& b);

}  // namespace armlet::lang
