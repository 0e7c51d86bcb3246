#include "check/statements/usage.hpp"

#include <algorithm>

#include "check/explain/pauses.hpp"
#include "check/state/checker.hpp"
#include "check/statements/changes.hpp"
#include "check/statements/paths.hpp"

namespace armlet::lang {

namespace {

// Whether the entry declares a function again that earlier entries know.
bool replaces_functions(const Checker& main) {
  const KeptNames* before = main.shared.earlier.kept();
  return before != nullptr && std::ranges::any_of(main.names.functions(), [&](const auto& entry) {
           const KeptName* old = before->main().find(entry.first);
           return old != nullptr && old->function != nullptr;
         });
}

// A call above a declaration may read the variable before it has a value; such reads are checked at
// run time.
void mark_unset_globals(Checker& checker) {
  std::unordered_map<const hir::Variable*, std::size_t> order;
  const auto& entries = checker.shared.top_level.entries();
  for (std::size_t i = 0; i < entries.size(); ++i) order[entries[i].variable] = i;
  // In the order of the count of variables declared before the call: the first call of a function
  // is the one with the fewest variables.
  std::vector<std::pair<std::size_t, const hir::Function*>> calls;
  for (const auto& [function, declared] : checker.shared.uses.main_calls())
    calls.emplace_back(declared, function);
  std::ranges::stable_sort(calls, {}, [](const auto& call) { return call.first; });
  std::unordered_set<const hir::Function*> visited;
  for (const auto& [declared, first] : calls) {
    std::vector<const hir::Function*> open{first};
    while (!open.empty()) {
      const hir::Function* function = open.back();
      open.pop_back();
      if (!visited.insert(function).second) continue;
      const Use& use = checker.shared.uses.of(function);
      for (hir::Variable* variable : use.globals) {
        const auto at = order.find(variable);
        if (at != order.end() && at->second >= declared) variable->maybe_unset = true;
      }
      open.insert(open.end(), use.calls.begin(), use.calls.end());
    }
  }
  // Functions of earlier entries may call the ones that replace theirs at any time.
  const bool any_time = replaces_functions(checker);
  for (const auto& [variable, init] : entries) {
    if ((init->value == nullptr || any_time) && variable->storage == hir::Storage::kGlobal)
      variable->maybe_unset = true;
  }
}

// The global variables that a test needs, by their order in the text.
class Needs {
 public:
  explicit Needs(Shared& shared) : shared_(shared) {
    const auto& entries = shared.top_level.entries();
    for (std::size_t i = 0; i < entries.size(); ++i) order_[entries[i].variable] = i;
  }

  // Subtracts the cost of the search from `room`; empty if the rest is not sufficient.
  std::optional<std::vector<std::size_t>> of(const hir::Function* test, std::size_t& room) {
    needed_.clear();
    known_.clear();
    open_ = {&shared_.uses.of(test)};
    while (!open_.empty()) {
      if (cost() > room) return std::nullopt;
      const Use& use = *open_.back();
      open_.pop_back();
      for (hir::Variable* variable : use.globals) add(variable);
      for (const hir::Function* called : use.calls) {
        if (known_.insert(called).second) open_.push_back(&shared_.uses.of(called));
      }
    }
    room -= std::min(room, cost());
    std::ranges::sort(needed_);
    return needed_;
  }

 private:
  [[nodiscard]] std::size_t cost() const { return known_.size() + 10 * needed_.size(); }

  void add(const hir::Variable* variable) {
    const Use* const use = shared_.top_level.use_of(variable);
    if (use == nullptr || !known_.insert(variable).second) return;
    if (const auto at = order_.find(variable); at != order_.end()) needed_.push_back(at->second);
    open_.push_back(use);
  }

  Shared& shared_;
  std::unordered_map<const hir::Variable*, std::size_t> order_;
  std::unordered_set<const void*> known_;
  std::vector<const Use*> open_;
  std::vector<std::size_t> needed_;
};

// A test runs without the statements of the program, so the initialisers of the variables that it
// needs run before it.
void prepare_tests(Checker& checker) {
  if (checker.postponed.tests().empty()) return;
  // Each test has its own initialisers: their count may be the product of the counts of tests and
  // of variables.
  std::size_t room = 20'000'000;
  Needs needs(checker.shared);
  for (const hir::Test& test : checker.postponed.tests()) {
    const auto needed = needs.of(test.function, room);
    if (!needed) {
      checker.messages.begin_statement();
      return checker.report(make_diagnostic(
          "E0124", test.span, {"more than 2000000 first values of variables in front of tests"}));
    }
    std::vector<hir::Stmt*> body;
    for (const std::size_t i : *needed) {
      const auto& [variable, init] = checker.shared.top_level.entries()[i];
      variable->storage = hir::Storage::kGlobal;
      body.push_back(init);
    }
    if (body.empty()) continue;
    body.insert(body.end(), test.function->body->body.begin(), test.function->body->body.end());
    test.function->body->body = checker.seq(body);
  }
}

void check_conditions(Checker& checker) {
  for (const auto& [function, span] : checker.shared.postponed.conditions()) {
    if (!checker.shared.uses.may_pause(checker.shared.uses.of(function))) continue;
    checker.messages.begin_statement();
    report_pause(checker, *function, span);
  }
}

}  // namespace

void finish_usage(Checker& checker) {
  check_conditions(checker);
  check_condition_changes(checker);
  check_callbacks(checker);
  check_paths(checker);
  prepare_tests(checker);
  mark_unset_globals(checker);
}

}  // namespace armlet::lang
