// What the whole program shows about its parts: which top-level variables tests need, which may be
// read too early, and which conditions would wait.

#include <algorithm>

#include "check/checker.hpp"
#include "check/over_list.hpp"
#include "check/paths.hpp"
#include "check/recordings.hpp"

namespace armlet::lang {

// Everything that may be used when `seed` runs: what its functions use, and what these call.
Use Checker::closure_of(Use seed) {
  for (std::size_t i = 0; i < seed.calls.size(); ++i) {
    const Use& use = uses_[seed.calls[i]];
    for (hir::Variable* variable : use.globals) seed.add(variable);
    for (const hir::Function* function : use.calls) seed.add(function);
    seed.pauses = seed.pauses || use.pauses;
  }
  return seed;
}

// A call above a declaration may read the variable before it has a value: such reads are checked
// while running.
void Checker::mark_unset_globals() {
  std::map<const hir::Function*, std::size_t> earliest;
  for (const auto& [function, declared] : main_calls_) {
    const auto [at, fresh] = earliest.emplace(function, declared);
    if (!fresh) at->second = std::min(at->second, declared);
  }
  std::map<const hir::Variable*, std::size_t> order;
  for (std::size_t i = 0; i < top_level_.size(); ++i) order[top_level_[i].first] = i;
  for (const auto& [function, declared] : earliest) {
    Use seed;
    seed.add(function);
    for (hir::Variable* variable : closure_of(std::move(seed)).globals) {
      const auto at = order.find(variable);
      if (at != order.end() && at->second >= declared) variable->maybe_unset = true;
    }
  }
  for (const auto& [variable, init] : top_level_) {
    if (init->value == nullptr && variable->storage == hir::Storage::kGlobal)
      variable->maybe_unset = true;
  }
}

// A test runs without the program's text, so the variables that it needs are given their first
// values in front of it.
void Checker::prepare_tests() {
  for (hir::Test& test : tests_) {
    Use use = closure_of(uses_[test.function]);
    for (std::size_t i = 0; i < use.globals.size(); ++i) {
      const auto init = init_uses_.find(use.globals[i]);
      if (init == init_uses_.end()) continue;
      const Use more = closure_of(init->second);
      for (hir::Variable* variable : more.globals) use.add(variable);
    }
    std::vector<hir::Stmt*> body;
    for (const auto& [variable, init] : top_level_) {
      if (std::ranges::find(use.globals, variable) == use.globals.end()) continue;
      variable->storage = hir::Storage::kGlobal;
      body.push_back(init);
    }
    if (body.empty()) continue;
    body.insert(body.end(), test.function->body->body.begin(), test.function->body->body.end());
    test.function->body->body = seq(body);
  }
}

void Checker::check_conditions() {
  for (const auto& [function, span] : conditions_) {
    if (!closure_of(uses_[function]).pauses) continue;
    sink_.begin_statement();
    report_pause(*this, *function, span);
  }
}

void Checker::finish_usage() {
  check_conditions();
  check_callbacks(*this);
  check_paths(*this);
  prepare_tests();
  mark_unset_globals();
}

}  // namespace armlet::lang
