#pragma once
// Shapes of lines of other languages, written as text: "FOR @ FROM $ TO $ DO".
//
// A shape is a row of elements between blanks:
//   @     a word                      #     a number                    ?     a quoted text
//   $     a value: at least one piece, brackets in pairs, no comma outside of them
//   *     any pieces, also none, brackets in pairs
//   ...   the rest of the line unchanged, with comments
//   =1    the same text as the first of the elements above
//   ~x    the element x, directly behind the piece before it
//   ^x    the word x with these capitals
//   !x    no piece: what follows is not the mark x
//   |     no piece: the line begins here, without indentation
//   \x    the mark x itself, where it means something above
// Everything else stands for itself; capitals do not count.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "habits/pieces.hpp"

namespace armlet::lang {

// The position of a match, and the texts that match its elements @ # $ * ...
struct Found {
  std::size_t first = 0;  // pieces [first, last)
  std::size_t last = 0;
  std::vector<std::string> parts;
};

// The remaining count of comparisons for a line, since a shape with several `$` may match with many
// divisions.
using Patience = int;
inline constexpr Patience kPatience = 20'000;

// Matches a shape with all pieces [first, last) of a line.
[[nodiscard]] std::optional<Found> match_all(const Line& line, std::size_t first, std::size_t last,
                                             std::string_view shape, Patience& patience);
// The first match of a shape inside of pieces [first, last). A shape that begins with `$` matches
// only where a value can begin: after a bracket, a comma, an `=` or a `return`. Values contain
// neither `=` nor `return`.
[[nodiscard]] std::optional<Found> match_inside(const Line& line, std::size_t first,
                                                std::size_t last, std::string_view shape,
                                                Patience& patience);

}  // namespace armlet::lang
