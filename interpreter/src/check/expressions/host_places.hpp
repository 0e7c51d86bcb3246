#pragma once
// Elements and fields of host values, which the library reads and changes: q[0], img[x, y], q[0] =
// 30deg, p.x = 10mm. The functions "point.x=" and "point[]=" return the changed value, which
// replaces the old one in its variable.

#include <string_view>

#include "check/state/checker.hpp"

namespace armlet::lang {

// Whether `target` is a field or an element of a host value in a variable.
[[nodiscard]] bool is_host_part(Checker& checker, const ast::Expr& target);
// Assigns `value` to the part; null after a message.
hir::Stmt* store_host_part(Checker& checker, const ast::Expr& target, hir::Expr* value,
                           const ast::AssignStmt& assign);
// Changes the part by an operator: q[0] += 10deg.
hir::Stmt* change_host_part(Checker& checker, const ast::Expr& target,
                            const ast::AssignStmt& assign);

// An element or a part: img[x, y] calls "image.grey[]" for a value of the kind "grey" if that
// function exists, else "image[]"; img[x0:x1, y0:y1] calls "image[:]". Null if there is no such
// function.
[[nodiscard]] hir::Expr* host_element(Checker& checker, const ast::IndexExpr& index,
                                      hir::Expr* object);

}  // namespace armlet::lang
