#pragma once
// Messages about lines of other languages in the words of those who wrote them.

#include <vector>

#include "driver/trial.hpp"

namespace armlet::lang {

// Puts an explanation in the place of every error that a line, or a block, of another language
// causes: one whose edits make the message go away and leave no error at their own places. Other
// messages about the same lines that go away with it are dropped.
void explain_habits(std::vector<Diagnostic>& diagnostics, const SourceSet& sources, Trials& trials);

// Whether, after the edits of a message's fix, an error is shown at the places of the trial: also
// one whose explanation reaches there.
[[nodiscard]] bool fails_as_shown(const Trial& trial, const Diagnostic& repaired,
                                  const Trials& trials);

}  // namespace armlet::lang
