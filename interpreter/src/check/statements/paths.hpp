#pragma once
// path (name: value, ...) { }: moves that are planned and made as one motion (reference, 13.3).

#include <string>

#include "check/state/checker.hpp"

namespace armlet::lang {

[[nodiscard]] hir::Stmt* check_path(Checker& checker, const ast::PathStmt& stmt);

// `word`, such as return, would leave a path before it has been made: E0502.
[[nodiscard]] Diagnostic leaves_path(const std::string& word, Span span);

// When all functions are known: a path holds nothing that takes time or acts, but moves of one
// resource, also in the functions that it calls: E0502.
void check_paths(Checker& checker);

}  // namespace armlet::lang
