#pragma once
// assert and assertThrows: statements that show what they looked at.

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Stmt* check_assert(Checker& checker, const ast::CallExpr& call);
hir::Stmt* check_assert_throws(Checker& checker, const ast::CallExpr& call);

}  // namespace armlet::lang
