#pragma once
// The formatter of programs: `armlet fmt`.

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/source.hpp"

namespace armlet {

struct Formatted {
  std::optional<std::string> text = {};   // empty if the program cannot be parsed
  std::vector<Diagnostic> problems = {};  // the reasons
  bool changed_meaning = false;           // a defect of the formatter; `text` is then the old one
};

// Formats a program: indentation by four columns, one statement per line, lines of at most 100
// columns where they can be broken (docs/formatting.md has all rules). The meaning and all comments
// stay the same, and formatting the result again changes nothing. Programs with mistakes of syntax
// are not formatted. A defect of the formatter cannot damage a program, because the result is
// parsed and compared. If `cancelled` becomes true, in any thread, the function soon returns no
// text and only the message R0629.
[[nodiscard]] Formatted format_program(const Source& source,
                                       const std::atomic<bool>* cancelled = nullptr);

}  // namespace armlet
