#pragma once
// Maps: their types, literals, entries, methods and loops (language reference, section 8).

#include <optional>

#include "check/state/checker.hpp"

namespace armlet::lang {

// int[string] as it is written.
[[nodiscard]] const Type* map_type(Checker& checker, const ast::TypeExpr& written);

// The literal, as the map that is wanted if one is.
[[nodiscard]] hir::Expr* check_map(Checker& checker, const ast::MapExpr& map, const Type* expected);
// {} where a map is wanted.
[[nodiscard]] hir::Expr* empty_map(Checker& checker, const Type* type, Span span);
// The literal as a map of another type; null if an entry does not fit.
[[nodiscard]] hir::Expr* convert_map(Checker& checker, const hir::MapExpr& map, const Type* type);

// m[k]
[[nodiscard]] hir::Expr* entry_of(Checker& checker, const ast::IndexExpr& index, hir::Expr* map);
// The same in a place that is changed.
[[nodiscard]] std::optional<hir::Step> entry_step(Checker& checker, const ast::IndexExpr& index,
                                                  const Type* map);

// m.get(k, v), m.keys() and the like, also by the names of other languages; null: no such method.
[[nodiscard]] hir::Expr* call_of_map(Checker& checker, hir::Expr* map, const ast::CallExpr& call,
                                     const ast::MemberExpr& member);
// dict(), new HashMap(): how an empty map is written; null: it is none.
[[nodiscard]] hir::Expr* foreign_empty_map(Checker& checker, std::string_view name,
                                           std::size_t values, Span span);
// m.bolt: what is meant instead.
[[nodiscard]] std::optional<Fix> fix_of_map_member(const Checker& checker, const Type* map,
                                                   const ast::Name& member);

// A list of the keys or of the values.
[[nodiscard]] hir::Expr* parts_of_map(Checker& checker, hir::MapQuestion question, hir::Expr* map,
                                      Span span);

}  // namespace armlet::lang
