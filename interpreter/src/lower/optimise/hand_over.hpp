#pragma once
// Values that change their owner instead of being copied: arguments and variables whose last use is
// to be assigned or passed on.

#include <unordered_set>
#include <vector>

#include "lower/optimise/flow.hpp"

namespace armlet::lang {

// Marks the parameters that their functions assign to a variable of their own, or pass on to
// another function that does. Such a function begins by adopting what the caller hands over.
void mark_adopted_parameters(const hir::Module& module);

// Decides, now that all code is there, which uses are the last ones. MOVEREF with c = 1 becomes
// TAKE where nothing reads its source again; GIVE becomes MOVE where something does.
[[nodiscard]] Edits hand_over_last_uses(std::vector<WideInstr>& code, const CodeShape& shape);

}  // namespace armlet::lang
