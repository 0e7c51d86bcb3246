#pragma once
// Shapes of lines of other languages, written as text: "FOR @ FROM $ TO $ DO".
//
// A shape is a row of elements between blanks:
//   @     a word                      #     a number                    ?     a quoted text
//   $     a value: at least one piece, brackets in pairs, no comma outside of them
//   *     any pieces, also none, brackets in pairs
//   ...   the rest of the line as it is written, with comments
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

// Where a shape was found, and the text that each of its @ # $ * ... stands for.
struct Found {
  std::size_t first = 0;  // pieces [first, last)
  std::size_t last = 0;
  std::vector<std::string> parts;
};

// How many comparisons are left for a line: shapes with several `$` may fit in many ways.
using Patience = int;
inline constexpr Patience kPatience = 20'000;

// Whether pieces [first, last) of a line have a shape, all of them.
[[nodiscard]] std::optional<Found> match_all(const Line& line, std::size_t first, std::size_t last,
                                             std::string_view shape, Patience& patience);
// The first place in pieces [first, last) that has a shape. A shape that begins with `$` begins
// where a value can: behind a bracket, a comma, an `=` or a `return`. Values hold none of the last
// two.
[[nodiscard]] std::optional<Found> match_inside(const Line& line, std::size_t first,
                                                std::size_t last, std::string_view shape,
                                                Patience& patience);

}  // namespace armlet::lang
