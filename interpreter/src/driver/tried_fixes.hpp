#pragma once
// Removes fixes that do not work: the program is checked again with the edits of each fix.

#include <vector>

#include "driver/trial.hpp"

namespace armlet::lang {

// Checks the program with the edits of each fix, one fix at a time, and drops a fix if an error
// would be shown at an edited position or at the position of its message. When the limit of trials
// is reached, the remaining fixes stay, with Confidence::kMaybe.
void drop_useless_fixes(std::vector<Diagnostic>& diagnostics, Trials& trials);

}  // namespace armlet::lang
