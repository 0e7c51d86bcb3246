#pragma once
// Compares values by their contents.

#include "armlet/interpreter/object.hpp"
#include "armlet/interpreter/type.hpp"

namespace armlet::lang {

struct VmState;

// The operator == of the language. Numbers compare as in IEEE 754, also inside lists and records.
//
// The work is proportional to the count of objects in the two values, even if some are reached
// several times, and is counted as steps. Its memory counts for the limit of the heap.
//
// equal    the result.
// returns  false if the program has to stop; the failure is set.
[[nodiscard]] bool compare_values(VmState& state, Slot a, Slot b, const Type& type, bool& equal);

}  // namespace armlet::lang
