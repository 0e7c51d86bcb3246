// What the whole program shows about its parts: which top-level variables tests need, which may be
// read too early, and which conditions would wait.

#include <algorithm>

#include "check/calls/over_list.hpp"
#include "check/checker.hpp"
#include "check/statements/paths.hpp"
#include "check/statements/recordings.hpp"

namespace armlet::lang {

// Whether running what `use` mentions may wait or move.
bool Checker::may_pause(const Use& use) {
  if (!shared_.pausing) {
    // From the functions that pause themselves to those that call them.
    std::unordered_map<const hir::Function*, std::vector<const hir::Function*>> callers;
    std::vector<const hir::Function*> open;
    for (const auto& [function, mentioned] : uses_) {
      if (mentioned.pauses) open.push_back(function);
      for (const hir::Function* called : mentioned.calls) callers[called].push_back(function);
    }
    auto& pausing = shared_.pausing.emplace(open.begin(), open.end());
    while (!open.empty()) {
      const hir::Function* called = open.back();
      open.pop_back();
      for (const hir::Function* caller : callers[called]) {
        if (pausing.insert(caller).second) open.push_back(caller);
      }
    }
  }
  return use.pauses || std::ranges::any_of(use.calls, [this](const hir::Function* called) {
           return shared_.pausing->contains(called);
         });
}

// A call above a declaration may read the variable before it has a value: such reads are checked
// while running.
void Checker::mark_unset_globals() {
  std::unordered_map<const hir::Variable*, std::size_t> order;
  for (std::size_t i = 0; i < top_level_.size(); ++i) order[top_level_[i].first] = i;
  // By rising number of variables declared before the call: the first visit of a function tells
  // most.
  std::vector<std::pair<std::size_t, const hir::Function*>> calls;
  for (const auto& [function, declared] : main_calls_) calls.emplace_back(declared, function);
  std::ranges::stable_sort(calls, {}, [](const auto& call) { return call.first; });
  std::unordered_set<const hir::Function*> visited;
  for (const auto& [declared, first] : calls) {
    std::vector<const hir::Function*> open{first};
    while (!open.empty()) {
      const hir::Function* function = open.back();
      open.pop_back();
      if (!visited.insert(function).second) continue;
      const Use& use = uses_[function];
      for (hir::Variable* variable : use.globals) {
        const auto at = order.find(variable);
        if (at != order.end() && at->second >= declared) variable->maybe_unset = true;
      }
      open.insert(open.end(), use.calls.begin(), use.calls.end());
    }
  }
  for (const auto& [variable, init] : top_level_) {
    if (init->value == nullptr && variable->storage == hir::Storage::kGlobal)
      variable->maybe_unset = true;
  }
}

namespace {

// The top-level variables that a test needs, by their order in the text.
class Needs {
 public:
  explicit Needs(SharedState& shared) : shared_(shared) {
    for (std::size_t i = 0; i < shared.top_level.size(); ++i) order_[shared.top_level[i].first] = i;
  }

  // Takes from `room` what looking costs; nothing if that is not enough.
  std::optional<std::vector<std::size_t>> of(const hir::Function* test, std::size_t& room) {
    needed_.clear();
    known_.clear();
    open_ = {&shared_.uses[test]};
    while (!open_.empty()) {
      if (cost() > room) return std::nullopt;
      const Use& use = *open_.back();
      open_.pop_back();
      for (hir::Variable* variable : use.globals) add(variable);
      for (const hir::Function* called : use.calls) {
        if (known_.insert(called).second) open_.push_back(&shared_.uses[called]);
      }
    }
    room -= std::min(room, cost());
    std::ranges::sort(needed_);
    return needed_;
  }

 private:
  [[nodiscard]] std::size_t cost() const { return known_.size() + 10 * needed_.size(); }

  void add(const hir::Variable* variable) {
    const auto init = shared_.init_uses.find(variable);
    if (init == shared_.init_uses.end() || !known_.insert(variable).second) return;
    if (const auto at = order_.find(variable); at != order_.end()) needed_.push_back(at->second);
    open_.push_back(&init->second);
  }

  SharedState& shared_;
  std::unordered_map<const hir::Variable*, std::size_t> order_;
  std::unordered_set<const void*> known_;
  std::vector<const Use*> open_;
  std::vector<std::size_t> needed_;
};

}  // namespace

// A test runs without the program's text, so the variables that it needs are given their first
// values in front of it.
void Checker::prepare_tests() {
  if (tests_.empty()) return;
  // Each test has its own: tests of many variables by many tests are as many first values as both
  // multiplied.
  std::size_t room = 20'000'000;
  Needs needs(shared_);
  for (hir::Test& test : tests_) {
    const auto needed = needs.of(test.function, room);
    if (!needed) {
      sink_.begin_statement();
      return report(make_diagnostic(
          "E0124", test.span, {"more than 2000000 first values of variables in front of tests"}));
    }
    std::vector<hir::Stmt*> body;
    for (const std::size_t i : *needed) {
      const auto& [variable, init] = top_level_[i];
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
    if (!may_pause(uses_[function])) continue;
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
