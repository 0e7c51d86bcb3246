#pragma once
// Java's printf, converted while checking, so that its format has to be a literal.

#include <optional>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// The texts that System.out.printf("...", values) prints, in order, for %d %s %b %f %.2f %e %g %n
// %% with their widths and flags. Empty after a message.
std::optional<std::vector<hir::Expr*>> printf_parts(Checker& checker, const ast::CallExpr& call);
// A call of print(text).
hir::Expr* print_line(Checker& checker, const ast::CallExpr& call, hir::Expr* text);
// The call that prints these texts.
hir::Expr* print_formatted(Checker& checker, const ast::CallExpr& call);

}  // namespace armlet::lang
