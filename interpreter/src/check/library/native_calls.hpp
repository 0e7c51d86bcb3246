#pragma once
// Checks calls of a library function that has been selected.

#include <span>
#include <string_view>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Expr* call_native(Checker& checker, std::string_view name,
                       std::span<const NativeFunction* const> candidates, Span callee, Span span,
                       std::vector<Argument> arguments);
[[nodiscard]] const Fact* ambient_fact(Checker& checker, std::string_view type);
void note_pause(Checker& checker, Span span);

hir::Expr* run_rule(Checker& checker, std::string_view name, const std::vector<Argument>& arguments,
                    const Fit& fit, hir::CallNativeExpr* call);

}  // namespace armlet::lang
