#pragma once
// The last statement of an entry, whose value a prompt shows.

#include "check/state/checker.hpp"

namespace armlet::lang {

// Checks the last statement of the main file of an entry. The value of an expression becomes the
// variable `ans`; of a declaration the variable is shown. Returns null if no statement is needed
// for this.
hir::Stmt* check_last(Checker& checker, const ast::Stmt& stmt);

}  // namespace armlet::lang
