#pragma once
// Moves values instead of copying them, where an argument or a variable is used for the last time.

#include <unordered_set>
#include <vector>

#include "lower/optimise/flow.hpp"

namespace armlet::lang {

// Marks the parameters that functions take over: those that they assign to a variable of their own,
// or pass on to a function that does. Such a function begins by becoming the owner of the argument.
void mark_adopted_parameters(const hir::Module& module);

// Finds the last uses, once all code of the function exists. MOVEREF with c = 1 becomes TAKE if no
// instruction reads its source again; GIVE becomes MOVE if one does.
[[nodiscard]] Edits hand_over_last_uses(std::vector<WideInstr>& code, const CodeShape& shape);

}  // namespace armlet::lang
