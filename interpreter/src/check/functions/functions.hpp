#pragma once
// Checks script functions: one typed form for each combination of argument types, with result types
// inferred from the bodies.

#include <string_view>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

Instance* instance_of(Checker& checker, FunctionDecl& function, std::vector<const Type*> types,
                      Span call);
void check_body(Checker& checker, Instance& instance);
hir::Block* value_body(Checker& checker, const ast::Expr& expr, FunctionContext& context);
void finish_result(Checker& checker, FunctionContext& context, std::string_view name, Span end);
hir::Expr* function_value(Checker& checker, FunctionDecl& function, const Type* expected,
                          Span span);
// Searches the columns of a table with unknown columns in functions that are not checked yet.
// Returns false, after a message, if no table is ever assigned.
bool settle(Checker& checker, const hir::Expr& table);
hir::Stmt* return_value(Checker& checker, hir::Expr* value, Span span);

}  // namespace armlet::lang
