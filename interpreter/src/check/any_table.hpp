#pragma once
// `table` as a written type: it stands for tables with any columns, so the type itself comes from
// what is given, as if none were written.

#include "check/checker.hpp"

namespace armlet::lang {

[[nodiscard]] bool is_any_table(const Checker& checker, const ast::TypeExpr* type);
// Null where the type comes from what is given: none is written, or `table`.
const Type* resolve_open(Checker& checker, const ast::TypeExpr* type);
// The value; where `table` is written and it is none, that is reported, and it has failed.
hir::Expr* require_table(Checker& checker, const ast::TypeExpr* type, hir::Expr* value);

}  // namespace armlet::lang
