#pragma once
// null, None, nil ... of other languages: here every value is there.

#include "check/state/checker.hpp"

namespace armlet::lang {

[[nodiscard]] bool is_nothing(std::string_view name);

// x == null, null != x: says what can be asked instead (E0310). Null if neither side is such a
// word. other: the checked other side, once it is.
[[nodiscard]] const ast::Expr* nothing_in(Checker& checker, const ast::BinaryExpr& comparison);
hir::Expr* compared_with_nothing(Checker& checker, const ast::BinaryExpr& comparison,
                                 const ast::Expr& nothing, const hir::Expr& other);

}  // namespace armlet::lang
