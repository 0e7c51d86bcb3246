#pragma once
// Advice about loops.

#include "check/state/checker.hpp"

namespace armlet::lang {

// Reports W0754: for (var y = 0mm; y < 100mm; y += 10mm) accumulates the rounding errors of its
// steps. The loop's variable must still be in scope.
void advise_summed_steps(Checker& checker, const ast::ForStmt& loop);

}  // namespace armlet::lang
