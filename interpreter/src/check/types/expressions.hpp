#pragma once
// Checks names, literals, lists, `? :` and other expressions without operators and calls.

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Expr* read(Checker& checker, Local& local, FunctionContext& where, Span span);

// For editors: checks the parts of a failed assignment that were not checked.
void learn_targets(Checker& checker, const ast::Stmt& stmt);

hir::Expr* check_formatted(Checker& checker, const ast::FormattedExpr& text);
hir::Expr* in_format(Checker& checker, hir::Expr* value, const ast::FormatSpec& format);
hir::Expr* to_text(Checker& checker, hir::Expr* value);

}  // namespace armlet::lang
