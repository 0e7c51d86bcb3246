#pragma once
// A fix is given only if it works: the text is checked again with its edits.

#include <vector>

#include "driver/trial.hpp"

namespace armlet::lang {

// Checks the program again with the edits of each fix, one fix at a time, and drops every fix that
// leaves an error, as it would be shown, at a place that it changes or at the place of its message.
// When nothing more can be tried, the fixes that are left stay as they are, with
// Confidence::kMaybe.
void drop_useless_fixes(std::vector<Diagnostic>& diagnostics, Trials& trials);

}  // namespace armlet::lang
