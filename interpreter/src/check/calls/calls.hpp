#pragma once
// Checks calls, f(a), x.f(a), new T(a), and finds the function that is called. Arguments are
// checked in other files.

#include <string_view>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Expr* check_call(Checker& checker, const ast::CallExpr& call, const Type* expected);
hir::Expr* call_value(Checker& checker, hir::Expr* function, const ast::CallExpr& call);
hir::Expr* check_new_object(Checker& checker, const ast::NewObjectExpr& expr);
std::vector<Argument> arguments_of(Checker& checker, ast::Seq<ast::Arg> args,
                                   std::string_view callee);
// Whether an expression is the name without text that repairs insert for a missing value
// (syntax/repair).
[[nodiscard]] bool is_missing(const ast::Expr& expr);
[[nodiscard]] bool waits(Checker& checker, const ast::Expr& expr);
const Type* list_hint(Checker& checker, std::string_view callee, const ast::Arg& arg,
                      std::size_t position);

hir::Expr* call_script(Checker& checker, FunctionDecl& function, Span callee, Span span,
                       std::vector<Argument> arguments);
hir::Expr* construct(Checker& checker, const StructDecl& structure, Span callee, Span span,
                     std::vector<Argument> arguments);

}  // namespace armlet::lang
