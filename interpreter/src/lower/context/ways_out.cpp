#include "lower/context/ways_out.hpp"

#include <algorithm>
#include <utility>

namespace armlet::lang {

JumpTargets WaysOut::to(const hir::Stmt* target) const {
  const auto found = std::find_if(exits_.rbegin(), exits_.rend(),
                                  [&](const JumpTargets& exit) { return exit.target == target; });
  return *found;
}

TryScope WaysOut::close(std::uint32_t position) {
  TryScope scope = std::move(tries_.back());
  tries_.pop_back();
  const Emitter::Range range{scope.begin, position};
  if (scope.catching) scope.caught.push_back(range);
  if (scope.has_end()) scope.finals.push_back(range);
  return scope;
}

void WaysOut::reopen(TryScope scope, std::uint32_t position) {
  scope.begin = position;
  tries_.push_back(std::move(scope));
}

const std::vector<Emitter::Range>& WaysOut::begin_handler(std::uint32_t position) {
  TryScope& scope = tries_.back();
  scope.catching = false;
  scope.begin = position;
  return scope.caught;
}

bool WaysOut::finally_runs() const { return std::ranges::any_of(tries_, &TryScope::has_end); }

}  // namespace armlet::lang
