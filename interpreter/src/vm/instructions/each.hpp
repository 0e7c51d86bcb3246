#pragma once
// Loops whose body is one instruction: executes several iterations at once, up to the first that
// would fail. Each iteration counts a step, as in other loops; at least one iteration is left for
// the instruction itself.

#include "vm/state/state.hpp"

namespace armlet::lang {

// For sums of doubles. They start with the value `sum`, and return the new sum, which is stored in
// register a as well.
using SumEach = double(StepMeter& steps, Slot* base, const Instr* pc, double sum);
SumEach add_each, add_product_each, add_product_of_two_each, add_product_with_row_each;
// For other instructions.
using Each = void(StepMeter& steps, Slot* base, const Instr* pc);
Each add_int_each, store_each, copy_each, update_each, update_minus_each;

}  // namespace armlet::lang
