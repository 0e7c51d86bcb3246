#pragma once
// What authors align in columns: the `=` of declarations below each other, and comments at the ends
// of lines.

#include <string>
#include <vector>

#include "format/doc.hpp"

namespace armlet::lang {

// The text of the lines. The `=` of neighbouring lines that stood in one column, at least one of
// them behind several blanks, stand in one column again. A comment at the end of a line stays in
// its column, or moves right if the line is longer; neighbours in one column move together.
[[nodiscard]] std::string aligned(std::vector<OutLine> lines, std::string_view line_end);

}  // namespace armlet::lang
