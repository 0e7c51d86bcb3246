#pragma once
// The gaps between the tokens of a program: comments and line breaks.

#include <string_view>
#include <vector>

#include "syntax/tokens/shape.hpp"

namespace armlet::lang {

struct Comment {
  std::string_view text;  // without trailing blanks
  int column = 0;         // on the screen, from 0
  int breaks_before = 0;  // line breaks before it, since the last comment or token
};

// The gap before one token.
struct Gap {
  std::vector<Comment> comments;
  int breaks_before = 0;   // line breaks between the last comment and the token
  std::size_t at_end = 0;  // the first comments that belong to the line of the token before

  [[nodiscard]] bool has_break() const {
    for (const Comment& comment : comments) {
      if (comment.breaks_before > 0) return true;
    }
    return breaks_before > 0;
  }
};

// One gap for each token. The gaps of inserted tokens are empty: comments belong to the token of
// the text after them. `begin` is the byte where the program begins.
[[nodiscard]] std::vector<Gap> read_gaps(const Source& source, const Shape& shape,
                                         std::uint32_t begin);

// The display column, from 0, of a byte of a text.
[[nodiscard]] int display_column(const Source& source, std::uint32_t offset);

}  // namespace armlet::lang
