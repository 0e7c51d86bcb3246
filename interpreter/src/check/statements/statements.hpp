#pragma once
// Checks statements other than loops, switches and declarations.

#include <string_view>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

void append(const ast::Stmt& stmt, hir::Stmt* checked, std::vector<hir::Stmt*>& out);
// Whether an expression statement has a value. `assert` and some others have the form of calls, but
// are statements.
[[nodiscard]] bool is_value_statement(Checker& checker, const ast::ExprStmt& stmt);
hir::Expr* seconds(Checker& checker, const ast::Expr& written, std::string_view what);

}  // namespace armlet::lang
