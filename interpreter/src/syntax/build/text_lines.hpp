#pragma once
// The lines of a text between three quotes: which part of it counts, and its common indentation.

#include <cstddef>
#include <string_view>

namespace armlet::lang {

// A line break directly behind the opening quotes does not belong to the text, nor does a last line
// that holds only blanks and the closing quotes. The blanks that all other lines begin with are
// left out; lines that hold nothing have no say, the line of the closing quotes has. The line of
// the opening quotes stays as it is.
struct TextLines {
  std::size_t begin = 0;  // bytes of what stands between the quotes
  std::size_t end = 0;
  std::size_t indentation = 0;  // bytes that lines begin with and that are left out

  // Where the text goes on behind a line break or an opening that ends at `at`.
  [[nodiscard]] std::size_t line_start(std::string_view raw, std::size_t at) const;
};

[[nodiscard]] TextLines lines_of_text(std::string_view raw);

// Bytes of the line break at `at`; 0 if none stands there.
[[nodiscard]] std::size_t line_break_at(std::string_view raw, std::size_t at);

}  // namespace armlet::lang
