#pragma once
// Values of the wrong type.

#include <string>

#include "check/state/checker.hpp"

namespace armlet::lang {

// Why two types that are written alike are not the same; empty if they are not written alike.
[[nodiscard]] std::string namesakes(const Type* one, const Type* other);

hir::Expr* mismatch(Checker& checker, const hir::Expr& value, const Target& target);

}  // namespace armlet::lang
