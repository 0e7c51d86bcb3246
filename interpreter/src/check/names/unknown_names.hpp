#pragma once
// Messages about undeclared names, and about calls that other languages write differently.

#include <string_view>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// Reports count = 3 without a declaration. `place` is the target, which starts with the unknown
// name `root`.
void unknown_variable(Checker& checker, const ast::Expr& root, const ast::Expr& place,
                      Span statement);
// Reports console.log(x), math.sin(x); null if the call is none of these.
hir::Expr* foreign_method(Checker& checker, const ast::CallExpr& call,
                          const ast::MemberExpr& member, std::string_view full);
// Reports len(q); null if the call is none of these.
hir::Expr* foreign_call(Checker& checker, const ast::CallExpr& call, std::string_view name);
// Reports q(0) for a variable q that is not a function.
hir::Expr* not_a_function(Checker& checker, const ast::CallExpr& call, std::string_view name,
                          const Type* type);
// Reports run("Syn", p, 2,5) if two values without a blank after their comma were meant as one
// number.
bool refuse_decimal_comma(Checker& checker, const std::vector<Argument>& arguments);
// The value of a type that stands for "no value yet", such as "" or 0; empty if the type has none.
[[nodiscard]] std::string_view empty_value(const Type& type);
// Reports const gap = 20mm, Integer n = 3, def f(x) { ... }: words of other languages in the
// position of a type. False if `name` is none of these.
bool refuse_foreign_type(Checker& checker, std::string_view name, Span span);

// Reports E0201 for a method that does not exist. The fix is a function of a module with this name,
// or the method that corresponds to one of Java. object: the type of the value before the point.
hir::Expr* unknown_method(Checker& checker, const ast::CallExpr& call,
                          const ast::MemberExpr& member, const Type& object);
// Reports E0201 with the most similar name.
hir::Expr* unknown_name(Checker& checker, std::string_view name, Span span,
                        const Type* expected = nullptr);
[[nodiscard]] std::optional<Fix> did_you_mean(const Checker& checker, std::string_view name,
                                              Span span, const Type* wanted);
[[nodiscard]] std::optional<Fix> did_you_mean(const Checker& checker, std::string_view name,
                                              Span span,
                                              const std::vector<std::string_view>& names);

}  // namespace armlet::lang
