#pragma once
// Values as text: f"value {j + 1} at {q[j]:.1f deg}".

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Expr* check_formatted(Checker& checker, const ast::FormattedExpr& text);
hir::Expr* in_format(Checker& checker, hir::Expr* value, const ast::FormatSpec& format);
hir::Expr* to_text(Checker& checker, hir::Expr* value);

}  // namespace armlet::lang
