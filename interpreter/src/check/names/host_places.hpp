#pragma once
// Elements and parts of values of the host, which its library offers: q[0], img[x, y], and storing
// into them, q[0] = 30deg, p.x = 10mm. "point.x=" and "point[]=" give the changed value, which is
// stored where the old one was.

#include <string_view>

#include "check/state/checker.hpp"

namespace armlet::lang {

// Whether `target` is a field or an element of a host value in a variable.
[[nodiscard]] bool is_host_part(Checker& checker, const ast::Expr& target);
// The part gets `value`; null after a message.
hir::Stmt* store_host_part(Checker& checker, const ast::Expr& target, hir::Expr* value,
                           const ast::AssignStmt& assign);
// The part changes by an operator: q[0] += 10deg.
hir::Stmt* change_host_part(Checker& checker, const ast::Expr& target,
                            const ast::AssignStmt& assign);

// Fact::kind of a value, also of a variable that changes; empty: it has none.
[[nodiscard]] std::string_view kind_of(const hir::Expr& value);
// An element or a part: img[x, y] calls "image.grey[]" for one of the kind "grey" where there is
// such a row, else "image[]", and img[x0:x1, y0:y1] "image[:]". Null if there is no such row.
[[nodiscard]] hir::Expr* host_element(Checker& checker, const ast::IndexExpr& index,
                                      hir::Expr* object);

}  // namespace armlet::lang
