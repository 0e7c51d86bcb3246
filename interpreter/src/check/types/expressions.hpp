#pragma once
// Names, literals, lists, `? :` and what else is no operator and no call.

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Expr* read(Checker& checker, Local& local, FunctionContext& where, Span span);

// For editors: the parts of an assignment that were not looked at, since it failed.
void learn_targets(Checker& checker, const ast::Stmt& stmt);

hir::Expr* check_formatted(Checker& checker, const ast::FormattedExpr& text);
hir::Expr* in_format(Checker& checker, hir::Expr* value, const ast::FormatSpec& format);
hir::Expr* to_text(Checker& checker, hir::Expr* value);

}  // namespace armlet::lang
