#pragma once
// Which functions are small enough to stand in place of their calls.

#include "check/tree/hir.hpp"

namespace armlet::lang {

// Sets Function::expands: a few operations on numbers, no loops, no other calls, nothing changed
// but their own variables. While such a body runs, nothing else of the program does.
void mark_inlined_functions(const hir::Module& module);

}  // namespace armlet::lang
