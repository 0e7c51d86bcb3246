#pragma once
// Facts that need the whole program: the global variables that tests need, variables that may be
// read too early, and conditions that would wait.

#include "check/state/checker.hpp"

namespace armlet::lang {

// Notes a call at the current position, for the order in which the top level runs.
void note_call(Checker& checker, const hir::Function* function);
void finish_usage(Checker& checker);

}  // namespace armlet::lang
