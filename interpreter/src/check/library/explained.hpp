#pragma once
// explain(f(x)): explains the result of f(x), although the call does not fail.

#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// The call that gives the explanation, if the argument of `name` is a call of a library function
// that can explain itself; null otherwise. `m.explain(m.f(x))` is the same as `explain(m.f(x))`.
[[nodiscard]] hir::Expr* explained_call(Checker& checker, std::string_view name,
                                        const std::vector<Argument>& arguments, Span span);

// The call that prints the explanation, for explain(x) as a statement; null for other statements.
[[nodiscard]] hir::Expr* shown_explanation(Checker& checker, const ast::ExprStmt& stmt,
                                           hir::Expr* value);

}  // namespace armlet::lang
