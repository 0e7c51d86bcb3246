#pragma once
// Checks functions inside functions: lambdas, which copy captured variables, and conditions and
// tasks, which share them.

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Expr* check_lambda(Checker& checker, const ast::LambdaExpr& lambda, const Type* expected);
// A condition as a function without parameters.
hir::Expr* check_guard(Checker& checker, const ast::Expr& condition);
hir::Expr* closure(Checker& checker, hir::Function* function, FunctionContext& context,
                   const Type* type, Span span);

}  // namespace armlet::lang
