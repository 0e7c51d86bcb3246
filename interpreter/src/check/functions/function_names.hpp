#pragma once
// Names of functions as values: map(xs, f), map(xs, sqrt).

#include "check/state/checker.hpp"

namespace armlet::lang {

// The script function that `expr` names, f or module.f; null if it names none.
[[nodiscard]] const FunctionDecl* written_function(Checker& checker, const ast::Expr& expr);
// The library function that `expr` names, sqrt or Math.sqrt; empty if it names none.
[[nodiscard]] std::string library_function(Checker& checker, const ast::Expr& expr);
// The value of `sqrt` where a function is expected: fn(x) => sqrt(x). Null if no library function
// has the name, or no function type is expected.
hir::Expr* library_function_value(Checker& checker, const ast::Expr& written, std::string_view name,
                                  const Type* expected);
// The text of a lambda such as fn(x, y) => hypot(x, y), with parameters that are not declared here;
// empty if the functions of this name have different counts of parameters.
[[nodiscard]] std::string lambda_around(Checker& checker, std::string_view function);

}  // namespace armlet::lang
