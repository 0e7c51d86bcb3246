#pragma once
// Functions of the library that take functions of the program: those that are loops of the program,
// and those that call back.

#include <span>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// fold(xs, 0, f): a whole number written as the start becomes what the elements are, because what f
// gives does. 0 becomes any quantity, other numbers a double.
void settle_start(Checker& checker, std::span<const NativeFunction* const> candidates,
                  std::vector<Argument>& arguments);

// The call as a loop; null if it is none. The key of sort and what is looked for must be
// comparable.
[[nodiscard]] hir::Expr* over_list(Checker& checker, const NativeFunction& function,
                                   hir::CallNativeExpr& call);

// Remembers functions handed to the library, which calls them while time stands still.
void note_callbacks(Checker& checker, const NativeFunction& function,
                    const std::vector<hir::Expr*>& values);

// Refuses those of them that would take time (E0520); after everything is checked.
void check_callbacks(Checker& checker);

}  // namespace armlet::lang
