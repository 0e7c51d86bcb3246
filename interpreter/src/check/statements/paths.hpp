#pragma once
// path (name: value, ...) { }: moves that are planned and executed as one motion (reference, 13.3).

#include <string>

#include "check/state/checker.hpp"

namespace armlet::lang {

[[nodiscard]] hir::Stmt* check_path(Checker& checker, const ast::PathStmt& stmt);

// E0502 for a `word`, such as return, that would leave a path before its motion.
[[nodiscard]] Diagnostic leaves_path(const std::string& word, Span span);

// Reports E0502 for statements in a path that take time or act, other than moves of one resource,
// also in the functions that it calls. Called when all functions are known.
void check_paths(Checker& checker);

}  // namespace armlet::lang
