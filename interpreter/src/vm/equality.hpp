#pragma once
// Comparing values by their contents.

#include "armlet/interpreter/object.hpp"
#include "armlet/interpreter/type.hpp"

namespace armlet::lang {

// The language's ==. Numbers compare as IEEE 754 says, also inside lists and records.
[[nodiscard]] bool equal_values(Slot a, Slot b, const Type& type);

}  // namespace armlet::lang
