#pragma once
// Which functions are small enough to stand in place of their calls.

#include "hir/analysis.hpp"

namespace armlet::lang {

// A few operations on numbers, no loops, no other calls, nothing changed but their own variables.
// While such a body runs, nothing else of the program does.
[[nodiscard]] FunctionSet inlined_functions(const hir::Module& module);

}  // namespace armlet::lang
