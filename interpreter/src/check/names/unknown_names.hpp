#pragma once
// What is said of names that nothing stands behind, and of calls that other languages write
// otherwise.

#include <string_view>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// count = 3 without a declaration. `place` starts with the unknown name `root`.
void unknown_variable(Checker& checker, const ast::Expr& root, const ast::Expr& place,
                      Span statement);
// console.log(x), math.sin(x): a message; null if the call is none of these.
hir::Expr* foreign_method(Checker& checker, const ast::CallExpr& call,
                          const ast::MemberExpr& member, std::string_view full);
// len(q): a message; null if the call is none of these.
hir::Expr* foreign_call(Checker& checker, const ast::CallExpr& call, std::string_view name);
// q(0) for a variable q that is no function.
hir::Expr* not_a_function(Checker& checker, const ast::CallExpr& call, std::string_view name,
                          const Type* type);
// run("Syn", p, 2,5): whether two values that touch their comma were one number.
bool refuse_decimal_comma(Checker& checker, const std::vector<Argument>& arguments);
// What a variable of a type holds when it holds nothing yet, such as "" or 0; empty if the type has
// no such value.
[[nodiscard]] std::string_view empty_value(const Type& type);
// const gap = 20mm, Integer n = 3, def f(x) { ... }: words that other languages have where a type
// stands; false if `name` is none of these.
bool refuse_foreign_type(Checker& checker, std::string_view name, Span span);

// Reports E0201 for a method that nothing has: a function of a module with this name, or what Java
// calls so. object: the type of what stands in front of the point.
hir::Expr* unknown_method(Checker& checker, const ast::CallExpr& call,
                          const ast::MemberExpr& member, const Type& object);
// Reports E0201 with the best suggestion.
hir::Expr* unknown_name(Checker& checker, std::string_view name, Span span,
                        const Type* expected = nullptr);
[[nodiscard]] std::optional<Fix> did_you_mean(const Checker& checker, std::string_view name,
                                              Span span, const Type* wanted);
[[nodiscard]] std::optional<Fix> did_you_mean(const Checker& checker, std::string_view name,
                                              Span span,
                                              const std::vector<std::string_view>& names);

}  // namespace armlet::lang
