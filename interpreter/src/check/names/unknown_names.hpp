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
// Reports run("Syn", p, 2,5) if two values without a blank after their comma were meant as one
// number.
bool refuse_decimal_comma(Checker& checker, const std::vector<Argument>& arguments);
// The value of a type that stands for "no value yet", such as "" or 0; empty if the type has none.
[[nodiscard]] std::string_view empty_value(const Type& type);
// Reports const gap = 20mm, Integer n = 3, def f(x) { ... }: words of other languages in the
// position of a type. False if `name` is none of these.
bool refuse_foreign_type(Checker& checker, std::string_view name, Span span);

// Reports E0201 with the most similar name.
hir::Expr* unknown_name(Checker& checker, std::string_view name, Span span,
                        const Type* expected = nullptr);
[[nodiscard]] std::optional<Fix> did_you_mean(const Checker& checker, std::string_view name,
                                              Span span, const Type* wanted);
[[nodiscard]] std::optional<Fix> did_you_mean(const Checker& checker, std::string_view name,
                                              Span span,
                                              const std::vector<std::string_view>& names);

}  // namespace armlet::lang
