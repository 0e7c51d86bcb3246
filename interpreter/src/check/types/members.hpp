#pragma once
// Checks x.name and x[i].

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Expr* check_member(Checker& checker, const ast::MemberExpr& member,
                        const Type* expected = nullptr);
hir::Expr* field_of(Checker& checker, hir::Expr* object, const ast::MemberExpr& member);
hir::Expr* unknown_field(Checker& checker, const hir::Expr& object, const ast::Name& field);
hir::Expr* check_index(Checker& checker, const ast::IndexExpr& index);
// The indexed value, for messages about an index: its span, and the expression for the count of its
// elements.
struct Indexed {
  Span object{};
  std::string_view size = "length";
};
// The value of an index. Reports E0340 if the text shows that it is negative.
hir::Expr* index_value(Checker& checker, const ast::Expr& expr, const Indexed& of = {});
// For editors: notes that `name` refers to field `field` of a struct.
void note_field_use(Checker& checker, const Type& record, std::size_t field, Span name);
// "System.out" for a chain of names that are no variables; empty otherwise.
[[nodiscard]] std::string dotted_name(Checker& checker, const ast::Expr& expr);

}  // namespace armlet::lang
