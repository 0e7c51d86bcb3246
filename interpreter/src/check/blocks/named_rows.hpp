#pragma once
// Rows of a block that the program names: `field clearance(80mm)`, made by "panel.field.NAME".
//
// What such a row gives as `value` is a variable of the top level, `panel1.clearance`, which the
// program reads and its host may set.

#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// The rows as the list `rows`, in their order; nothing if there are none. What gives their
// variables the first values is added to `out`.
std::vector<Argument> named_rows(Checker& checker, const ast::ObjectStmt& stmt,
                                 std::vector<hir::Stmt*>& out);

// A block with such rows stands once, at the top level of the program's own file; says so if not.
[[nodiscard]] bool may_have_named_rows(Checker& checker, const ast::ObjectStmt& stmt);

// The variable of a row, `panel1.clearance`; null if the name in front is of no such block.
hir::Expr* named_row_value(Checker& checker, const ast::MemberExpr& member);

}  // namespace armlet::lang
