#pragma once
// Library functions that take script functions: those that are compiled to loops, and those that
// call them from C++.

#include <span>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// fold(xs, 0, f): an int literal as the start gets the type of the elements, because f returns that
// type. 0 becomes any quantity, other numbers become a double.
void settle_start(Checker& checker, std::span<const NativeFunction* const> candidates,
                  std::vector<Argument>& arguments);

// The call as a loop; null if it is not one. The key of sort and the value that contains and
// indexOf search must be comparable.
[[nodiscard]] hir::Expr* over_list(Checker& checker, const NativeFunction& function,
                                   hir::CallNativeExpr& call);

// Notes script functions that are passed to the library, which calls them while time stands still.
void note_callbacks(Checker& checker, const NativeFunction& function,
                    const std::vector<hir::Expr*>& values);

}  // namespace armlet::lang
