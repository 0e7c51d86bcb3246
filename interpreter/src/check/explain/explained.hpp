#pragma once
// explain(f(x)): says how f(x) comes about, without its failing first.

#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// The call that says it, if the value handed to `name` is a call of a library function that can
// explain itself; null otherwise. `m.explain(m.f(x))` is the same as `explain(m.f(x))`.
[[nodiscard]] hir::Expr* explained_call(Checker& checker, std::string_view name,
                                        const std::vector<Argument>& arguments, Span span);

// explain(x) as a statement: the call that prints it; null if the statement is another one.
[[nodiscard]] hir::Expr* shown_explanation(Checker& checker, const ast::ExprStmt& stmt,
                                           hir::Expr* value);

}  // namespace armlet::lang
