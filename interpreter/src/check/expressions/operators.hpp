#pragma once
// Checks operators: numbers and quantities with the angle rule of section 6, texts, bools, and the
// operators of the library.

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Expr* check_unary(Checker& checker, const ast::UnaryExpr& unary, const Type* expected);
hir::Expr* check_binary(Checker& checker, const ast::BinaryExpr& binary, const Type* expected);
hir::Expr* combine(Checker& checker, const ast::BinaryExpr& node, hir::Expr* left,
                   hir::Expr* right);

}  // namespace armlet::lang
