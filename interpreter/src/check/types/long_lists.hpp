#pragma once
// Structs and enums of any size, and default values of any depth: the time and the code for a use
// do not depend on their size.

#include "check/state/checker.hpp"

namespace armlet::lang {

// The list State.values of an enum.
[[nodiscard]] hir::Expr* enum_values(Checker& checker, const Type* type, Span span);

// The default value of an absent argument; `file` is the file that declares it.
[[nodiscard]] hir::Expr* default_value(Checker& checker, Checker& file, const ast::Expr& expr,
                                       const Target& target);

hir::Expr* enum_name(Checker& checker, hir::Expr* value, Span span);

}  // namespace armlet::lang
