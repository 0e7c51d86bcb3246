#pragma once
// Checks names, literals, lists, `? :` and other expressions without operators and calls.

#include "check/state/checker.hpp"

namespace armlet::lang {

// For editors: checks the parts of a failed assignment that were not checked.
void learn_targets(Checker& checker, const ast::Stmt& stmt);

}  // namespace armlet::lang
