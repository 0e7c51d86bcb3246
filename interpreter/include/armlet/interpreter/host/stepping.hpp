#pragma once
// Running by statements and to breakpoints, for programs with markers (CompileOptions::markers).
//
//     vm.run({.statements = 1});            // one statement, of whichever task
//     set_breakpoints(vm, {{.line = 14}});  // the next run pauses before what begins on line 14

#include <compare>
#include <cstdint>
#include <vector>

#include "armlet/interpreter/host/vm.hpp"

namespace armlet {

// A line of a source of the program: 0 is its main file.
struct SourceLine {
  std::uint32_t source = 0;
  int line = 0;
  auto operator<=>(const SourceLine&) const = default;
};

// The lines on which statements begin, sorted: those that can have a breakpoint. None in a program
// without markers.
[[nodiscard]] std::vector<SourceLine> statement_lines(const Program& program);

// From now on runs pause before every statement that begins on one of these lines, also when a
// budget is left. What cannot pause, such as a condition, goes on. Those that were given before are
// forgotten. Returns the lines as they were taken: for a line without a statement, the next one of
// its file that has one.
//
// throws  ArgumentError while the Vm runs, and for a program without markers.
std::vector<SourceLine> set_breakpoints(Vm& vm, std::vector<SourceLine> lines);

// Whether the run has paused at one.
[[nodiscard]] bool is_at_breakpoint(Vm& vm);

// How many statements have begun.
[[nodiscard]] std::uint64_t statements_begun(Vm& vm);

}  // namespace armlet
