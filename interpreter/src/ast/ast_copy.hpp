#pragma once
// A statement that stands in another text too, at the same or another place.

#include "armlet/interpreter/source.hpp"
#include "ast/ast.hpp"
#include "base/arena.hpp"

namespace armlet::lang {

// A copy of a statement, `shift` bytes further on in `text`, which has the same bytes there. It
// keeps nothing of the text and the arena that the statement is in.
[[nodiscard]] ast::Stmt* copied(const ast::Stmt& stmt, Arena& arena, const Source& text,
                                std::int64_t shift);

}  // namespace armlet::lang
