#pragma once
// Reports statements that only compute a value.

#include "check/state/checker.hpp"

namespace armlet::lang {

// Whether the computation of a value has no effect, so that a statement with only this value does
// nothing.
[[nodiscard]] bool does_nothing(const hir::Expr& value);
// Reports E0332: a call without its parentheses, or the result of a function as the last line,
// which other languages return.
void refuse_idle_statement(Checker& checker, const ast::ExprStmt& stmt, const hir::Expr& value);
// Reports W0746 if the statement is a call of a function without effects, such as sort(xs). Not in
// a `try` and not in a function that is passed on, where the call may test whether it fails; nor if
// an argument is a function, which may have effects.
void advise_forgotten_value(Checker& checker, const ast::ExprStmt& stmt, const hir::Expr& value);

}  // namespace armlet::lang
