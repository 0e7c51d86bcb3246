#pragma once
// Explains lines of other languages: the form of each in this one, or that it has no counterpart.
//
// An explanation is a guess from the form of a line. It is used only if a message of the parser or
// the checker marks the line, and only if its edits remove that message
// (driver/explained_habits.hpp).

#include <string>
#include <vector>

#include "armlet/interpreter/diagnostic.hpp"

namespace armlet::lang {

// Without edits if there is no counterpart.
struct Explanation {
  Diagnostic message;
  bool of_value = false;  // of a part of a statement
  bool names_it = false;  // the marked word is part of the habit's row
};

// Explanations of the line with a message's mark, the best first: of its whole statement, then of
// values in it.
[[nodiscard]] std::vector<Explanation> explain_line(const Source& source, Span mark);

// The blocks in a text that are written as in other languages.
class ForeignBlocks {
 public:
  explicit ForeignBlocks(const Source& source);

  // Explanations of the blocks around a line, the outermost first, then the innermost.
  [[nodiscard]] std::vector<Explanation> around(int line) const;

  struct Block {
    int first = 0;  // lines, from 1
    int last = 0;
    std::string found;  // the first line in the text
    std::string here;   // its form in this language; empty: not needed
    bool by_indentation = false;
    std::vector<Edit> edits{};
  };

 private:
  [[nodiscard]] Diagnostic explanation(const Block& outer) const;

  const Source& source_;
  std::vector<Block> blocks_;  // inner ones before the outer ones
};

// A statement with all of its values in the form of this language.
[[nodiscard]] std::string with_values_here(std::string text);
// A text, shortened for the headline of a message.
[[nodiscard]] std::string shortened(const std::string& text);

}  // namespace armlet::lang
