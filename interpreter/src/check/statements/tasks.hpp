#pragma once
// Blocks that run as tasks: parallel, when, every (reference, section 12).

#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// One of the three.
[[nodiscard]] hir::Stmt* check_tasks(Checker& checker, const ast::Stmt& stmt);

// The state of variables of `where` as it is here: tasks keep their own.
[[nodiscard]] const Flow& flow_for(const Checker& checker, const FunctionContext& where);
// The variable has a value from here on, by whatever name `here` knows it.
void note_assigned(FunctionContext& here, const hir::Variable* variable);

// Two branches of one `parallel` that begin by commanding the same resource: E0501. `word` is where
// the statement begins.
void refuse_busy_resources(Checker& checker, Span word,
                           const std::vector<const hir::Function*>& branches);

}  // namespace armlet::lang
