#pragma once
// Explains null, None, nil ... of other languages: in this one every variable has a value.

#include "check/state/checker.hpp"

namespace armlet::lang {

[[nodiscard]] bool is_nothing(std::string_view name);

// x == null, null != x: reports E0310 with a test that can replace the comparison. Returns null if
// neither side is such a word. other: the other side, once it is checked.
[[nodiscard]] const ast::Expr* nothing_in(Checker& checker, const ast::BinaryExpr& comparison);
hir::Expr* compared_with_nothing(Checker& checker, const ast::BinaryExpr& comparison,
                                 const ast::Expr& nothing, const hir::Expr& other);

}  // namespace armlet::lang
