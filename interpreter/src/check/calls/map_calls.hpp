#pragma once
// Methods of maps.

#include <string_view>

#include "check/state/checker.hpp"

namespace armlet::lang {

// Calls m.get(k, v), m.keys() and other methods, also with their names in other languages; null if
// there is no such method.
[[nodiscard]] hir::Expr* call_of_map(Checker& checker, hir::Expr* map, const ast::CallExpr& call,
                                     const ast::MemberExpr& member);
// The empty map for dict(), new HashMap(); null if the call is no such one.
[[nodiscard]] hir::Expr* foreign_empty_map(Checker& checker, std::string_view name,
                                           std::size_t values, Span span);

}  // namespace armlet::lang
