#pragma once
// Values that a basic block computes twice.

#include <functional>
#include <vector>

#include "compile/liveness.hpp"

namespace armlet::lang {

// Local value numbering: finds instructions whose value a register holds already, lets what reads
// their result read that register instead, and says which instructions can go. A value whose
// register is needed for something else before it is wanted again moves to a `fresh` one.
// returns  by position: whether the instruction, or operand word, is to be removed.
[[nodiscard]] std::vector<bool> find_repeats(std::vector<WideInstr>& code, const CodeShape& shape,
                                             const std::function<Reg()>& fresh);

}  // namespace armlet::lang
