#pragma once
// Checks assignment targets: variables, elements and fields.

#include <optional>

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Stmt* check_assign(Checker& checker, const ast::AssignStmt& assign);
hir::Stmt* check_step(Checker& checker, const ast::StepStmt& step);
hir::Expr* read_place(Checker& checker, const hir::Place& place);
// The expression `target + value` for `target += value`, which combine checks.
ast::BinaryExpr operation_of(const ast::AssignStmt& assign, const ast::Expr& target);

}  // namespace armlet::lang
