#pragma once
// Messages about values of the wrong type.

#include <string>

#include "check/state/checker.hpp"

namespace armlet::lang {

// The reason why two types with the same name are different; empty if their names differ.
[[nodiscard]] std::string namesakes(const Type* one, const Type* other);

hir::Expr* mismatch(Checker& checker, const hir::Expr& value, const Target& target);

}  // namespace armlet::lang
