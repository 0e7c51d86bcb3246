#pragma once
// Selects the functions that are small enough to be inlined.

#include "hir/analysis.hpp"

namespace armlet::lang {

// The functions with a few operations on numbers, without loops and calls, that change no variables
// but their own. No other code of the program runs during such a body.
[[nodiscard]] FunctionSet inlined_functions(const hir::Module& module);

}  // namespace armlet::lang
