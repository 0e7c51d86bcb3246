#pragma once
// Java's printf, read while checking: its text must be written in the program.

#include <optional>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// The texts that System.out.printf("...", values) prints, in order. %d %s %b %f %.2f %e %g %n %%
// are known; a width or a flag is refused. Empty after a message.
std::optional<std::vector<hir::Expr*>> printf_parts(Checker& checker, const ast::CallExpr& call);
// print(text)
hir::Expr* print_line(Checker& checker, const ast::CallExpr& call, hir::Expr* text);
// The call that prints them.
hir::Expr* print_formatted(Checker& checker, const ast::CallExpr& call);

}  // namespace armlet::lang
