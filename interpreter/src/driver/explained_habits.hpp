#pragma once
// Explains lines in the syntax of other languages, in the words of those languages.

#include <vector>

#include "driver/trial.hpp"

namespace armlet::lang {

// Replaces every error that a line or a block of another language causes by an explanation, if the
// edits of the explanation remove the message and leave no error at the edited positions. Other
// messages about the same lines that these edits remove are dropped.
void explain_habits(std::vector<Diagnostic>& diagnostics, const SourceSet& sources, Trials& trials);

// Whether, after the edits of a message's fix, an error is shown at the edited positions, or an
// explanation whose mark includes them.
[[nodiscard]] bool fails_as_shown(const Trial& trial, const Diagnostic& repaired,
                                  const Trials& trials);

}  // namespace armlet::lang
