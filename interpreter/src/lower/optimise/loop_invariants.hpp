#pragma once
// Rows of nested lists that stay the same in all passes of a loop.

#include <functional>
#include <vector>

#include "lower/optimise/flow.hpp"

namespace armlet::lang {

// rows[i][j] in a loop that changes neither rows nor i: rows[i] is looked up once, before the loop.
// A row that is missing is told of where the program needs it. Where the loop stores into rows,
// nobody else sees the row from there on.
//
// fresh  a register of its own for every call.
[[nodiscard]] Edits hoist_loop_invariants(std::vector<WideInstr>& code, const CodeShape& shape,
                                          const std::function<Reg()>& fresh);

}  // namespace armlet::lang
