#pragma once
// Checks switch: each case is a list of tests and a block.

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Stmt* check_switch(Checker& checker, const ast::SwitchStmt& stmt);

}  // namespace armlet::lang
