#pragma once
// Storing into a part of a value of the host, which its library offers: q[0] = 30deg, p.x = 10mm.
// "point.x=" and "point[]=" give the changed value, which is stored where the old one was.

#include "check/checker.hpp"

namespace armlet::lang {

// Whether `target` is a field or an element of a host value in a variable.
[[nodiscard]] bool is_host_part(Checker& checker, const ast::Expr& target);
// The part gets `value`; null after a message.
hir::Stmt* store_host_part(Checker& checker, const ast::Expr& target, hir::Expr* value,
                           const ast::AssignStmt& assign);
// The part changes by an operator: q[0] += 10deg.
hir::Stmt* change_host_part(Checker& checker, const ast::Expr& target,
                            const ast::AssignStmt& assign);

}  // namespace armlet::lang
