#pragma once
// The lines of a text in three quotes: the part that belongs to the text, and the common
// indentation.

#include <cstddef>
#include <string_view>

namespace armlet::lang {

// A line break directly after the opening quotes does not belong to the text, nor does a last line
// with only blanks and the closing quotes. The blanks that all lines begin with are removed. Empty
// lines are not considered for this; the line of the closing quotes is. The line of the opening
// quotes is unchanged.
struct TextLines {
  std::size_t begin = 0;  // positions of the text between the quotes, bytes
  std::size_t end = 0;
  std::size_t indentation = 0;  // bytes of the removed blanks

  // The start of the text after a line break or an opening quote that ends at `at`.
  [[nodiscard]] std::size_t line_start(std::string_view raw, std::size_t at) const;
};

[[nodiscard]] TextLines lines_of_text(std::string_view raw);

// The length of the line break at `at`, bytes; 0 if there is none.
[[nodiscard]] std::size_t line_break_at(std::string_view raw, std::size_t at);

}  // namespace armlet::lang
