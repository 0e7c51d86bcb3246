#pragma once
// Values that are computed again though a register has them.

#include <functional>
#include <vector>

#include "lower/optimise/flow.hpp"

namespace armlet::lang {

// Value numbering: finds instructions whose value a register holds already, lets what reads their
// result read that register instead, and says which instructions can go. What is known at the end
// of a block is known in all blocks that only it leads to, as far as nothing between them, nor
// later passes of a loop around, change it. A value whose register is needed for something else
// before it is wanted again moves to a `fresh` one.
[[nodiscard]] Edits number_values(std::vector<WideInstr>& code, const CodeShape& shape,
                                  const std::function<Reg()>& fresh);

}  // namespace armlet::lang
