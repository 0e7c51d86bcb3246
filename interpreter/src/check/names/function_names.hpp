#pragma once
// Names of functions where a value is expected: map(xs, f), map(xs, sqrt).

#include "check/state/checker.hpp"

namespace armlet::lang {

// The function of the program that `expr` names, f or module.f; null if it names none.
[[nodiscard]] const FunctionDecl* written_function(Checker& checker, const ast::Expr& expr);
// The function of the library that `expr` names, sqrt or Math.sqrt; empty if it names none.
[[nodiscard]] std::string library_function(Checker& checker, const ast::Expr& expr);
// `sqrt` where a function is expected: fn(x) => sqrt(x). Null if no function of the library has the
// name, or no function type is expected.
hir::Expr* library_function_value(Checker& checker, const ast::Expr& written, std::string_view name,
                                  const Type* expected);
// fn(x, y) => hypot(x, y), with names that are not taken here; empty if the functions of this name
// take different numbers of values.
[[nodiscard]] std::string lambda_around(Checker& checker, std::string_view function);

}  // namespace armlet::lang
