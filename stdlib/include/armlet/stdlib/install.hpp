#pragma once
// Adds the vocabulary of robot programs to an engine.

#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/engine.hpp"

namespace armlet {

// Everything of the language reference, section 19, that exists so far. Programs compiled by this
// engine need a Host as CompileOptions::host and VmOptions::host (see session.hpp, which does
// both).
void install(Engine& engine);

// An engine with this vocabulary, made at the first call and never changed: any thread may use it.
[[nodiscard]] const Engine& library_engine();

// A chapter of the library, in the order of the reference.
struct LibraryChapter {
  std::string_view title;
  bool is_mathematics = false;  // docs/mathematics.md says what each of its functions is in C++
};
[[nodiscard]] std::vector<LibraryChapter> library_chapters();

// What programs may say but is refused because nothing stands behind it yet (E0199), in the words
// of that message and in the order of the tables that refuse it.
[[nodiscard]] std::vector<std::string> later_features();

}  // namespace armlet
