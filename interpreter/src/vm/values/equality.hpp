#pragma once
// Comparing values by their contents.

#include "armlet/interpreter/object.hpp"
#include "armlet/interpreter/type.hpp"

namespace armlet::lang {

struct VmState;

// The language's ==. Numbers compare as IEEE 754 says, also inside lists and records.
//
// The work is proportional to the objects that the two values are made of, however often each is
// reached, and is counted as steps; what it keeps in mind counts against the heap limit.
// equal    the answer.
// returns  false: the program has to stop, and the failure is set.
[[nodiscard]] bool compare_values(VmState& state, Slot a, Slot b, const Type& type, bool& equal);

}  // namespace armlet::lang
