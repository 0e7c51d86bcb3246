#pragma once
// What the whole program shows about its parts: which top-level variables tests need, which may be
// read too early, and which conditions would wait.

#include "check/state/checker.hpp"

namespace armlet::lang {

// A call from here, for the order in which the top level runs.
void note_call(Checker& checker, const hir::Function* function);
void finish_usage(Checker& checker);

}  // namespace armlet::lang
