#pragma once
// Checks while, do and for.

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Stmt* check_loop(Checker& checker, const ast::Stmt& stmt);

}  // namespace armlet::lang
