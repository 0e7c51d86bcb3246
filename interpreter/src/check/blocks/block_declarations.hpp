#pragma once
// Block declarations, T name { field: value; row constructor(...) }, for structs and for host types
// with a function "T{}".

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Stmt* check_object(Checker& checker, const ast::ObjectStmt& stmt);

// Reports E0201 for a row whose words are not those of this block.
hir::Expr* unknown_row(Checker& checker, const ast::ObjectStmt& stmt, const ast::BlockItem& item);

}  // namespace armlet::lang
