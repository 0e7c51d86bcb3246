#pragma once
// T name { field: value; row constructor(...) }: for structs, and for host types with a function
// "T{}".

#include "check/checker.hpp"

namespace armlet::lang {

hir::Stmt* check_object(Checker& checker, const ast::ObjectStmt& stmt);

}  // namespace armlet::lang
