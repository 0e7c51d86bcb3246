#pragma once
// Checks assert and assertThrows, whose failures show the values of the condition.

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Stmt* check_assert(Checker& checker, const ast::CallExpr& call);
hir::Stmt* check_assert_throws(Checker& checker, const ast::CallExpr& call);

}  // namespace armlet::lang
