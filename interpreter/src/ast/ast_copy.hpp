#pragma once
// Copies of statements from one text into another, for edits that leave most statements unchanged.

#include "armlet/interpreter/source.hpp"
#include "ast/ast.hpp"
#include "base/arena.hpp"

namespace armlet::lang {

// A copy of a statement, moved by `shift` bytes, for a new `text` that has the same bytes at the
// new position. The copy does not refer to the old text or the old arena.
[[nodiscard]] ast::Stmt* copied(const ast::Stmt& stmt, Arena& arena, const Source& text,
                                std::int64_t shift);

}  // namespace armlet::lang
