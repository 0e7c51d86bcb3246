#pragma once
// The one layout of programs: `armlet fmt`.

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/source.hpp"

namespace armlet {

struct Formatted {
  std::optional<std::string> text = {};   // nothing if the program cannot be read
  std::vector<Diagnostic> problems = {};  // why not
  bool changed_meaning = false;  // a defect: the layout would have changed more; `text` is the old
};

// Lays a program out: four columns of indentation, a statement to a line, lines of at most 100
// columns where a break is possible (docs/formatting.md has all rules). The program means the same
// before and after, every comment is kept, and laying it out again changes nothing. Only programs
// without mistakes of syntax are laid out. A defect of the formatter cannot damage a program: the
// result is read again and compared. Set `cancelled` to true, from any thread, and it ends soon,
// without a text and with the message R0629 alone.
[[nodiscard]] Formatted format_program(const Source& source,
                                       const std::atomic<bool>* cancelled = nullptr);

}  // namespace armlet
