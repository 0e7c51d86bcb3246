#pragma once

#include "check/state/checker.hpp"

namespace armlet::lang {

// new Bin[3] and new Bin[2][3], where the struct has defaults for all of its fields; null: `type`
// is no such struct.
[[nodiscard]] hir::Expr* new_structs(Checker& checker, const ast::NewArrayExpr& expr,
                                     const Type* type);

}  // namespace armlet::lang
