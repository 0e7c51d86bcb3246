#pragma once

#include "check/state/checker.hpp"

namespace armlet::lang {

// new Bin[3] and new Bin[2][3] of a struct whose fields all have defaults; null if `type` is no
// such struct.
[[nodiscard]] hir::Expr* new_structs(Checker& checker, const ast::NewArrayExpr& expr,
                                     const Type* type);

}  // namespace armlet::lang
