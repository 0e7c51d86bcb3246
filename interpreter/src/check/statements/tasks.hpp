#pragma once
// Checks blocks that run as tasks: parallel, when, every (reference, section 12).

#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// Checks one of these statements.
[[nodiscard]] hir::Stmt* check_tasks(Checker& checker, const ast::Stmt& stmt);

// Reports E0501 for two branches of one `parallel` that begin with commands to the same resource.
// `word` is the start of the statement.
void refuse_busy_resources(Checker& checker, Span word,
                           const std::vector<const hir::Function*>& branches);

}  // namespace armlet::lang
