#pragma once
// Messages about values with a missing or wrong unit (language reference, section 20.3, E04xx).

#include "check/state/checker.hpp"

namespace armlet::lang {

void plain_number_for_quantity(Checker& checker, const hir::Expr& value, const Target& target);
void quantity_for_number(Checker& checker, const hir::Expr& value);
void other_quantity(Checker& checker, const hir::Expr& value, const Target& target);

}  // namespace armlet::lang
