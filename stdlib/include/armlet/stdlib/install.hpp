#pragma once
// Adds the library of robot programs to an engine.

#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/engine.hpp"

namespace armlet {

// Adds all of section 19 of the language reference. Programs compiled by this engine need a Host as
// CompileOptions::host and VmOptions::host (session.hpp provides both).
void install(Engine& engine);

// An engine with this library, made at the first call and then constant: any thread may use it.
[[nodiscard]] const Engine& library_engine();

// A chapter of the library, in the order of the reference.
struct LibraryChapter {
  std::string_view title;
  bool is_mathematics = false;  // its functions are in docs/mathematics.md
};
[[nodiscard]] std::vector<LibraryChapter> library_chapters();

}  // namespace armlet
