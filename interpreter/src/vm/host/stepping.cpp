#include "armlet/interpreter/host/stepping.hpp"

#include <algorithm>

#include "armlet/core/error.hpp"
#include "vm/state/turn.hpp"

namespace armlet {

std::vector<SourceLine> statement_lines(const Program& program) {
  std::vector<SourceLine> lines;
  for (const lang::FunctionCode& function : program.compiled().functions) {
    auto at = function.spans.begin();
    for (std::uint32_t pc = 0; pc < function.code.size(); ++pc) {
      if (function.code[pc].op != lang::OpCode::MARK) continue;
      while (at + 1 != function.spans.end() && (at + 1)->pc <= pc) ++at;
      lines.push_back({at->span.source, program.sources().position(at->span).line});
    }
  }
  std::ranges::sort(lines);
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  return lines;
}

std::vector<SourceLine> set_breakpoints(Vm& vm, std::vector<SourceLine> lines) {
  lang::VmState& state = vm.state();
  const lang::Turn turn(state);
  if (!state.programs.newest->functions[0].has_markers)
    throw ArgumentError("Breakpoints need a program with markers (CompileOptions).");
  const std::vector<SourceLine> known = statement_lines(vm.program());
  std::vector<SourceLine> taken;
  for (const SourceLine& line : lines) {
    const auto next = std::ranges::lower_bound(known, line);
    if (next != known.end() && next->source == line.source) taken.push_back(*next);
  }
  std::ranges::sort(taken);
  taken.erase(std::unique(taken.begin(), taken.end()), taken.end());
  state.marks.breakpoints = taken;
  return taken;
}

bool is_at_breakpoint(Vm& vm) { return vm.state().marks.is_at_breakpoint; }

std::uint64_t statements_begun(Vm& vm) {
  const lang::VmState& state = vm.state();
  return state.host.counts_apart ? state.host.aside.statements : state.marks.begun;
}

}  // namespace armlet
