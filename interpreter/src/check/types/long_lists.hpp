#pragma once
// Structs and enums of any size, and default values of any depth: the work and the code for a use
// do not grow with them.

#include "check/state/checker.hpp"

namespace armlet::lang {

// State.values
[[nodiscard]] hir::Expr* enum_values(Checker& checker, const Type* type, Span span);

// The value that a call leaves out; `file` is where it is written.
[[nodiscard]] hir::Expr* default_value(Checker& checker, Checker& file, const ast::Expr& expr,
                                       const Target& target);

hir::Expr* enum_name(Checker& checker, hir::Expr* value, Span span);

}  // namespace armlet::lang
