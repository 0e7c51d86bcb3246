#pragma once

#include "check/state/checker.hpp"

namespace armlet::lang {

// Reports advice about `let half = n // 2`, which divides in other languages: a comment that
// consists of a divisor, after an int that a statement stores or returns.
//
// type  the type of the variable or result; null: that of the value.
void advise_on_divided_remark(Checker& checker, const ast::Expr& written, const hir::Expr& value,
                              const Type* type);

}  // namespace armlet::lang
