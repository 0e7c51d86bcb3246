#pragma once
// Rows of a block that have names: `field clearance(80mm)`, made by "panel.field.NAME".
//
// The argument `value` of such a row becomes a global variable, `panel1.clearance`, which the
// program reads and its host may set.

#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// Returns the rows as the list argument `rows`, in their order; empty if there are none. The
// statements that give the variables their first values are added to `out`.
std::vector<Argument> named_rows(Checker& checker, const ast::ObjectStmt& stmt,
                                 std::vector<hir::Stmt*>& out);

// Whether a block with such rows is allowed at this position: only once, at the top level of the
// main file. Reports a message otherwise.
[[nodiscard]] bool may_have_named_rows(Checker& checker, const ast::ObjectStmt& stmt);

}  // namespace armlet::lang
