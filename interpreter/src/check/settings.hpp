#pragma once
// with (name: value, ...) { }

#include "check/checker.hpp"

namespace armlet::lang {

hir::Stmt* check_with(Checker& checker, const ast::WithStmt& stmt);

}  // namespace armlet::lang
