// Runs by statements and moves, forward and back.

#include <algorithm>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/stepping.hpp"
#include "session/run.hpp"

namespace armlet {

Progress Session::run_move() {
  const int moves = run_->is_under_way ? run_->host->move_count() : 0;
  while (run({.statements = 1}) == Progress::kPaused) {
    if (run_->host->move_count() != moves || is_at_breakpoint(*run_->vm)) break;
  }
  return run_->result.status;
}

bool Session::step_back() {
  require_run("step back");
  const std::uint64_t begun = statements_begun(*run_->vm);
  if (begun == 0) {
    throw ArgumentError(
        "There is no statement to step back over: none has begun, or the program has no markers.");
  }
  const OneSlice one_slice(*this);
  return take_again(run_->entries, [this, begun] {
    while (true) {
      begin_next();
      const std::uint64_t left = begun - 1 - statements_begun(*run_->vm);
      if (left == 0) return true;
      advance({.statements = left});
      if (run_->is_under_way || to_come() == 0) return true;
    }
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
  if (run_->vm != nullptr) armlet::set_breakpoints(*run_->vm, breakpoints_);
  return breakpoints_;
}

}  // namespace armlet
