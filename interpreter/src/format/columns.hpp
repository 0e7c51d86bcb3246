#pragma once
// Keeps columns that the author aligned: the `=` of consecutive declarations, and comments at the
// ends of lines.

#include <string>
#include <vector>

#include "format/doc.hpp"

namespace armlet::lang {

// The text of the lines. If the `=` of neighbouring lines were in one column, and at least one of
// them followed several blanks, they are aligned again. A comment at the end of a line stays in its
// column, or moves right if the line is longer; neighbouring comments in one column move together.
[[nodiscard]] std::string aligned(std::vector<OutLine> lines, std::string_view line_end);

}  // namespace armlet::lang
