#pragma once
// Statements that are nothing but a value.

#include "check/state/checker.hpp"

namespace armlet::lang {

// Whether computing a value changes nothing, so that a statement made of it does nothing.
[[nodiscard]] bool does_nothing(const hir::Expr& value);
// E0332: a call without its parentheses, or the result of a function that other languages return by
// itself.
void refuse_idle_statement(Checker& checker, const ast::ExprStmt& stmt, const hir::Expr& value);
// W0746, if the statement is the call of a function that changes nothing: sort(xs). In a `try` and
// in a function that is handed on, a call may be there to see whether it fails; a function that is
// given may do something.
void advise_forgotten_value(Checker& checker, const ast::ExprStmt& stmt, const hir::Expr& value);

}  // namespace armlet::lang
