#pragma once
// Lines of other languages, explained: what each is called here, or that there is no such thing.
//
// An explanation is a guess from the look of a line. It is given only where a message of the parser
// or the checker marks the line, and only if its edits make that message go away
// (driver/explained_habits.hpp).

#include <string>
#include <vector>

#include "armlet/interpreter/diagnostic.hpp"

namespace armlet::lang {

// Without edits: there is no such thing here.
struct Explanation {
  Diagnostic message;
  bool of_value = false;  // of a part of a statement
  bool names_it = false;  // the marked word stands in the row of the habit
};

// Explanations of the line that a message marks, the best first: of its whole statement, then of
// values in it.
[[nodiscard]] std::vector<Explanation> explain_line(const Source& source, Span mark);

// The blocks of other languages in a text.
class ForeignBlocks {
 public:
  explicit ForeignBlocks(const Source& source);

  // Explanations of the blocks around a line, the outermost first, then the innermost.
  [[nodiscard]] std::vector<Explanation> around(int line) const;

  struct Block {
    int first = 0;  // lines, from 1
    int last = 0;
    std::string found;  // the first line as it is written
    std::string here;   // as it is written here; empty: not needed
    bool by_indentation = false;
    std::vector<Edit> edits{};
  };

 private:
  [[nodiscard]] Diagnostic explanation(const Block& outer) const;

  const Source& source_;
  std::vector<Block> blocks_;  // inner ones before those around them
};

// The text of a statement with all values as they are written here.
[[nodiscard]] std::string with_values_here(std::string text);
// A text for the headline of a message.
[[nodiscard]] std::string shortened(const std::string& text);

}  // namespace armlet::lang
