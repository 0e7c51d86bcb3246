#pragma once
// The last statement of an entry: its value is shown by prompts, and kept.

#include "check/state/checker.hpp"

namespace armlet::lang {

// Checks the last statement of the main file of an entry. The value of an expression becomes the
// variable `ans`; a declaration of one variable shows it. Null where nothing is to be done.
hir::Stmt* check_last(Checker& checker, const ast::Stmt& stmt);

}  // namespace armlet::lang
