#pragma once
// Value numbering: values that are computed again although a register has them.

#include <functional>
#include <vector>

#include "lower/optimise/flow.hpp"

namespace armlet::lang {

// Finds instructions whose value a register has already, lets the readers of their result read that
// register, and reports which instructions can be removed. The values known at the end of a block
// are known in all blocks that it dominates, as long as no block between them and no later
// iteration of a loop changes them. If the register of a value is overwritten before the next use,
// the value moves to a `fresh` register.
[[nodiscard]] Edits number_values(std::vector<WideInstr>& code, const CodeShape& shape,
                                  const std::function<Reg()>& fresh);

}  // namespace armlet::lang
