#pragma once
// Loops of one instruction: several passes at once, as far as nothing in them fails. Every pass
// counts a step, as ever; at least one pass is left to the instruction itself.

#include "vm/state/state.hpp"

namespace armlet::lang {

// Of sums of doubles, which begin at `sum`. They give the sum so far, which is in register a too.
using SumEach = double(StepMeter& steps, Slot* base, const Instr* pc, double sum);
SumEach add_each, add_product_each, add_product_of_two_each, add_product_with_row_each;
// Of anything else.
using Each = void(StepMeter& steps, Slot* base, const Instr* pc);
Each add_int_each, store_each, copy_each, update_each, update_minus_each;

}  // namespace armlet::lang
