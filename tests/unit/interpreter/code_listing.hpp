#pragma once
// The instructions that a program is compiled to, as text.

#include <doctest/doctest.h>

#include <string>

#include "script_support.hpp"

namespace armlet::lang {

inline std::string listing(const std::string& program) {
  const Compilation compilation = compile_script(program);
  REQUIRE(compilation.program != nullptr);
  return compilation.program->disassemble();
}

// How often an instruction stands in a listing.
inline int count(const std::string& listing, const std::string& op) {
  int found = 0;
  const std::string name = "  " + op;
  for (std::size_t at = listing.find(name); at != std::string::npos;
       at = listing.find(name, at + 1)) {
    const char next = listing[at + name.size()];
    if (next == ' ' || next == 'r' || next == '#') ++found;
  }
  return found;
}

}  // namespace armlet::lang
