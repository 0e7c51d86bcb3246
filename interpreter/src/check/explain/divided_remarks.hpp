#pragma once

#include "check/state/checker.hpp"

namespace armlet::lang {

// Advice about `let half = n // 2`, which other languages divide: behind the number that a
// statement stores or returns, a comment that consists of a divisor.
//
// type  of the place where the value is stored; null: its own.
void advise_on_divided_remark(Checker& checker, const ast::Expr& written, const hir::Expr& value,
                              const Type* type);

}  // namespace armlet::lang
