#pragma once
// A fix is given only if it works: the text is checked again with its edits.

#include <vector>

#include "armlet/interpreter/engine.hpp"
#include "registry.hpp"

namespace armlet::lang {

// Checks the program again with the edits of each fix, one fix at a time, and drops every fix that
// leaves an error at a place that it changes or at the place of its message. The work is bounded:
// when more than 256 KB of text have been read again, the fixes that are left stay as they are, with
// Confidence::kMaybe.
//
// sources  the texts of the program.
// options  `load` is asked again for the files that the program imports.
void drop_useless_fixes(std::vector<Diagnostic>& diagnostics, const Registry& registry,
                        const SourceSet& sources, const CompileOptions& options);

}  // namespace armlet::lang
