#pragma once
// Checks declarations of variables, structs, enums, functions and tests.

#include <string_view>

#include "check/state/checker.hpp"

namespace armlet::lang {

void collect(Checker& checker, const ast::Block& program);
hir::Stmt* check_var(Checker& checker, const ast::VarStmt& stmt);
hir::Stmt* check_test(Checker& checker, const ast::TestStmt& stmt);
void check_waiting_tests(Checker& checker);

}  // namespace armlet::lang
