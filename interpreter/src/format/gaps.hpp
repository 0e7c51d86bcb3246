#pragma once
// What stands between the tokens of a program: comments and line breaks.

#include <string_view>
#include <vector>

#include "syntax/tokens/shape.hpp"

namespace armlet::lang {

struct Comment {
  std::string_view text;  // without blanks at its end
  int column = 0;         // on the screen, from 0
  int breaks_before = 0;  // line breaks between it and what comes before
};

// What stands in front of one token.
struct Gap {
  std::vector<Comment> comments;
  int breaks_before = 0;   // line breaks directly in front of the token, behind the last comment
  std::size_t at_end = 0;  // so many of the comments end the line of the token before

  [[nodiscard]] bool has_break() const {
    for (const Comment& comment : comments) {
      if (comment.breaks_before > 0) return true;
    }
    return breaks_before > 0;
  }
};

// One gap for each token. Inserted tokens have empty ones: what follows them belongs to the token
// after. `begin` is the offset where the program begins.
[[nodiscard]] std::vector<Gap> read_gaps(const Source& source, const Shape& shape,
                                         std::uint32_t begin);

// Display column, from 0, of a byte of a text.
[[nodiscard]] int display_column(const Source& source, std::uint32_t offset);

}  // namespace armlet::lang
