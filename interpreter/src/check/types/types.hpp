#pragma once
// Converts declared types to types of the checker.

#include <string_view>

#include "check/state/checker.hpp"

namespace armlet::lang {

const Type* type_called(Checker& checker, std::string_view name);

hir::Expr* cast(Checker& checker, hir::Expr* value, const Type* type, Span span);
[[nodiscard]] const Type* common_type(Checker& checker, const hir::Expr& a, const hir::Expr& b);

}  // namespace armlet::lang
