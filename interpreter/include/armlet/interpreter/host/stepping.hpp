#pragma once
// Runs by statements and to breakpoints, for programs with markers (CompileOptions::markers).
//
//     vm.run({.statements = 1});            // one statement, of whichever task
//     set_breakpoints(vm, {{.line = 14}});  // the next run pauses before what begins on line 14

#include <compare>
#include <cstdint>
#include <vector>

#include "armlet/interpreter/host/vm.hpp"

namespace armlet {

// A line in a source of the program; source 0 is the main file.
struct SourceLine {
  std::uint32_t source = 0;
  int line = 0;
  auto operator<=>(const SourceLine&) const = default;
};

// The lines on which statements begin, sorted: those that can have a breakpoint. Empty for a
// program without markers.
[[nodiscard]] std::vector<SourceLine> statement_lines(const Program& program);

// Lets runs pause before every statement that begins on one of these lines, even if their budget is
// not used up. Code that cannot pause, such as a condition, does not stop. The lines replace those
// of earlier calls. Returns the effective lines: a line without a statement becomes the next line
// of its file that has one.
//
// throws  ArgumentError while the Vm is running, and for a program without markers.
std::vector<SourceLine> set_breakpoints(Vm& vm, std::vector<SourceLine> lines);

// Whether the run is paused at a breakpoint.
[[nodiscard]] bool is_at_breakpoint(Vm& vm);

// The count of statements that have begun.
[[nodiscard]] std::uint64_t statements_begun(Vm& vm);

}  // namespace armlet
