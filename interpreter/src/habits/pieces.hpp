#pragma once
// Divides lines of other languages into words, numbers, texts and marks. The lexer of the language
// rejects such lines; this one accepts every line.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace armlet::lang {

struct Piece {
  enum class Kind : std::uint8_t { kWord, kNumber, kText, kMark };
  std::uint32_t begin = 0;  // position in the line
  std::uint32_t end = 0;
  Kind kind = Kind::kMark;
};

// One line and its pieces, without a comment that starts with //. Lines of more than 400 bytes,
// which are not hand-written, have no pieces.
struct Line {
  explicit Line(std::string_view written);

  [[nodiscard]] std::string_view piece(std::size_t i) const { return text_of(i, i + 1); }
  // The text from piece `first` to the one before piece `last`.
  [[nodiscard]] std::string_view text_of(std::size_t first, std::size_t last) const {
    if (first >= last) return {};
    return text.substr(pieces[first].begin, pieces[last - 1].end - pieces[first].begin);
  }

  std::string_view text;
  std::vector<Piece> pieces;
};

// A replacement of bytes [begin, end) of a line.
struct LineEdit {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::string text;
};

// The edits that change one line to another and leave the pieces that both have. A number with
// another unit is such a piece.
[[nodiscard]] std::vector<LineEdit> line_edits(std::string_view from, std::string_view to);

}  // namespace armlet::lang
