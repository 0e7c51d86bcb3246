#pragma once
// Values of rows of a block that the program names: panel1.clearance.

#include "check/state/checker.hpp"

namespace armlet::lang {

// The variable of a row, such as `panel1.clearance`; null if the object is not such a block.
hir::Expr* named_row_value(Checker& checker, const ast::MemberExpr& member);

}  // namespace armlet::lang
