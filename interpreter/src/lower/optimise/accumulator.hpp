#pragma once
// Operands that need not be read back from memory.
//
// Registers lie in memory, and a double that was just stored there comes back several times later
// than the arithmetic takes. The machine therefore keeps the double computed last in a register of
// the processor as well, and has forms of its instructions that take an operand from there.

#include <vector>

#include "lower/optimise/flow.hpp"

namespace armlet::lang {

// Chooses these forms; the results are the same bits. What a loop needs first and computes last is
// got ready before its first pass.
[[nodiscard]] Edits use_accumulator(std::vector<WideInstr>& code, const CodeShape& shape);

}  // namespace armlet::lang
