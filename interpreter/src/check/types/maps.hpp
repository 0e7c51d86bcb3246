#pragma once
// Checks maps: types, literals, entries, methods and loops (language reference, section 8).

#include <optional>

#include "check/state/checker.hpp"

namespace armlet::lang {

// The map type for a type in the text, such as int[string].
[[nodiscard]] const Type* map_type(Checker& checker, const ast::TypeExpr& written);

// Checks a literal, with the expected map type if there is one.
[[nodiscard]] hir::Expr* check_map(Checker& checker, const ast::MapExpr& map, const Type* expected);
// The value of {} where a map is expected.
[[nodiscard]] hir::Expr* empty_map(Checker& checker, const Type* type, Span span);
// Converts a literal to another map type; null if an entry does not fit.
[[nodiscard]] hir::Expr* convert_map(Checker& checker, const hir::MapExpr& map, const Type* type);

// The entry m[k].
[[nodiscard]] hir::Expr* entry_of(Checker& checker, const ast::IndexExpr& index, hir::Expr* map);
// The entry m[k] in an assignment target.
[[nodiscard]] std::optional<hir::Step> entry_step(Checker& checker, const ast::IndexExpr& index,
                                                  const Type* map);

// The fix for m.bolt, which may mean m["bolt"].
[[nodiscard]] std::optional<Fix> fix_of_map_member(const Checker& checker, const Type* map,
                                                   const ast::Name& member);

// The list of the keys or of the values.
[[nodiscard]] hir::Expr* parts_of_map(Checker& checker, hir::MapQuestion question, hir::Expr* map,
                                      Span span);

}  // namespace armlet::lang
