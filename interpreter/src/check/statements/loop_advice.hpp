#pragma once
// Advice about loops that are checked.

#include "check/state/checker.hpp"

namespace armlet::lang {

// W0754: for (var y = 0mm; y < 100mm; y += 10mm) adds up the rounding of its steps. The loop's
// variable is still in scope.
void advise_summed_steps(Checker& checker, const ast::ForStmt& loop);

}  // namespace armlet::lang
