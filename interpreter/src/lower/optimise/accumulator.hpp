#pragma once
// The accumulator: operands that need not be read from memory.
//
// The registers of the virtual machine are memory, and a double that was just stored there can be
// read again only after a delay that is several times longer than the arithmetic. The virtual
// machine therefore keeps the double that was computed last in a register of the processor as well,
// the accumulator, and has forms of its instructions that take an operand from it.

#include <vector>

#include "lower/optimise/flow.hpp"

namespace armlet::lang {

// Selects these forms; the results have the same bits. If a loop starts with the double that it
// computes last, the accumulator is loaded before the first iteration.
[[nodiscard]] Edits use_accumulator(std::vector<WideInstr>& code, const CodeShape& shape);

}  // namespace armlet::lang
