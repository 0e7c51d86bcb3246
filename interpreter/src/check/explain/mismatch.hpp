#pragma once
// Values of the wrong type.

#include "check/checker.hpp"

namespace armlet::lang {

hir::Expr* mismatch(Checker& checker, const hir::Expr& value, const Target& target);

}  // namespace armlet::lang
