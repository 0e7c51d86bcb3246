#pragma once
// Values of the program into those that a host owns, and back.

#include <string>

#include "armlet/interpreter/host/value.hpp"
#include "vm/state.hpp"

namespace armlet::lang {

// throws  ArgumentError, which begins with `what`, if there is a part that no host can hold: a
//         function, or an element without a value.
[[nodiscard]] Value value_in(Slot slot, const Type& type, const std::string& what);

// A slot that owns its value, which has the type.
//
// throws  ArgumentError, which begins with `what`, if the value is of another type or the heap is
//         full.
[[nodiscard]] Slot slot_of_value(VmState& state, const Value& value, const Type& type,
                                 const std::string& what);

// Whether types of two programs mean the same: equal names, fields, units and so on.
[[nodiscard]] bool is_same_type(const Type& a, const Type& b);

}  // namespace armlet::lang
