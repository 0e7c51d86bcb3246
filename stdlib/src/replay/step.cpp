// Runs by statements and moves, forward and back.

#include <algorithm>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/stepping.hpp"
#include "armlet/stdlib/session.hpp"
#include "replay/journal.hpp"

namespace armlet {

Progress Session::run_move() {
  const int moves = is_under_way_ ? host_->move_count() : 0;
  while (run({.statements = 1}) == Progress::kPaused) {
    if (host_->move_count() != moves || is_at_breakpoint(*vm_)) break;
  }
  return result_.status;
}

bool Session::step_back() {
  require_run("step back");
  const std::uint64_t begun = statements_begun(*vm_);
  if (begun == 0) {
    throw ArgumentError(
        "There is no statement to step back over: none has begun, or the program has no markers.");
  }
  return take_again(known_run(), [this, begun] {
    if (begun > 1) run_along({.statements = begun - 1});
  });
}

std::vector<SourceLine> Session::set_breakpoints(std::vector<SourceLine> lines) {
  require_idle("set breakpoints");
  if (program() == nullptr || !options_.markers)
    throw ArgumentError("Breakpoints need a program that was compiled with markers.");
  const std::vector<SourceLine> known = statement_lines(*program());
  breakpoints_.clear();
  for (const SourceLine& line : lines) {
    const auto next = std::ranges::lower_bound(known, line);
    if (next != known.end() && next->source == line.source) breakpoints_.push_back(*next);
  }
  if (vm_ != nullptr) armlet::set_breakpoints(*vm_, breakpoints_);
  return breakpoints_;
}

}  // namespace armlet
