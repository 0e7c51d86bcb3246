#pragma once
// The layout of a program, and the check that it leaves the comments unchanged.

#include <atomic>
#include <string>

#include "syntax/tokens/shape.hpp"

namespace armlet::lang {

// The text of a program in the layout of docs/formatting.md. Throws Cancelled soon after
// `cancelled` has become true.
[[nodiscard]] std::string lay_out(const Source& source, const Shape& shape,
                                  const std::atomic<bool>* cancelled = nullptr);

// Whether two programs have the same comments in the same order. Trailing blanks of their lines are
// ignored.
[[nodiscard]] bool same_comments(const Shape& a, const Source& a_text, const Shape& b,
                                 const Source& b_text);

}  // namespace armlet::lang
