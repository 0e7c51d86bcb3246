#pragma once
// Tables: their columns and their rows.

#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// The call of a function that the language itself has.
hir::Expr* builtin(Checker& checker, const NativeFunction& function, const Type* type, Span span,
                   std::vector<hir::Expr*> arguments);
// A column of a table: run.t, run.length.
hir::Expr* column_of(Checker& checker, hir::Expr* table, const ast::MemberExpr& member);
// The list that `for (row in run)` visits.
hir::Expr* rows_of(Checker& checker, hir::Expr* table);

}  // namespace armlet::lang
