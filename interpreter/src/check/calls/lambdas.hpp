#pragma once
// Functions inside functions: lambdas, which copy what they use, and conditions and tasks, which
// share it.

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Expr* check_lambda(Checker& checker, const ast::LambdaExpr& lambda, const Type* expected);
// a condition as a function
hir::Expr* check_guard(Checker& checker, const ast::Expr& condition);
hir::Expr* closure(Checker& checker, hir::Function* function, FunctionContext& context,
                   const Type* type, Span span);
hir::Variable* captured(Checker& checker, Local& local, FunctionContext& owner,
                        FunctionContext& here);

}  // namespace armlet::lang
