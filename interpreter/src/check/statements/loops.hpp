#pragma once
// while, do, for.

#include "check/checker.hpp"

namespace armlet::lang {

hir::Stmt* check_loop(Checker& checker, const ast::Stmt& stmt);

}  // namespace armlet::lang
