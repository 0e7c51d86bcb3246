#pragma once
// Loop-invariant code motion for the rows of nested lists.

#include <functional>
#include <vector>

#include "lower/optimise/flow.hpp"

namespace armlet::lang {

// rows[i][j] in a loop that changes neither rows nor i: rows[i] is looked up once, before the loop.
// A missing row is reported at the position in the text where the program uses it. If the loop
// stores into rows, the row is made an unshared copy at that point.
//
// fresh  gives an unused register at each call.
[[nodiscard]] Edits hoist_loop_invariants(std::vector<WideInstr>& code, const CodeShape& shape,
                                          const std::function<Reg()>& fresh);

}  // namespace armlet::lang
