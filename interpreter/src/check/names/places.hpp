#pragma once
// What stands in front of `=`: variables, elements and fields that can be changed.

#include <optional>

#include "check/state/checker.hpp"

namespace armlet::lang {

std::optional<hir::Place> check_place(Checker& checker, const ast::Expr& expr, Span statement,
                                      bool whole);
hir::Stmt* check_assign(Checker& checker, const ast::AssignStmt& assign);
hir::Stmt* check_step(Checker& checker, const ast::StepStmt& step);
hir::Expr* read_place(Checker& checker, const hir::Place& place);
// `target + value` of `target += value`: what combine checks.
ast::BinaryExpr operation_of(const ast::AssignStmt& assign, const ast::Expr& target);

}  // namespace armlet::lang
