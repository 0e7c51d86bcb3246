#include "check/statements/changes.hpp"

#include <vector>

#include "check/explain/pauses.hpp"
#include "hir/walk.hpp"

namespace armlet::lang {

namespace {

// Whether a variable exists after the function. Lists, structs and maps are values, so only such a
// variable can make a change visible outside.
bool outlives(const hir::Variable& variable, const hir::Function& function) {
  return variable.owner != &function || variable.outer != nullptr;
}

// Searches the text of one function.
class Search {
 public:
  Search(const hir::Function& function, Changes of) : function_(function), of_(of) {}

  std::optional<Change> run() {
    std::vector<const hir::Stmt*> open;
    if (function_.body != nullptr) open.push_back(function_.body);
    while (!open.empty() && !found_) {
      const hir::Stmt& stmt = *open.back();
      open.pop_back();
      if (stmt.kind == hir::StmtKind::kAssign) place(stmt.as<hir::AssignStmt>().place);
      if (stmt.kind == hir::StmtKind::kStorePart) place(stmt.as<hir::StorePartStmt>().place);
      const auto part_changes = [this](const hir::Expr& e) { return changes(e); };
      for_each_child(
          stmt, [&](const hir::Expr& e) { (void)(found_ || any_part(e, part_changes)); },
          [&](const hir::Stmt& child) { open.push_back(&child); });
    }
    return found_;
  }

 private:
  void place(const hir::Place& changed) {
    if (of_ == Changes::kOfLibrary || found_ || !outlives(*changed.variable, function_)) return;
    found_ = Change{changed.span, "`" + std::string(changed.variable->name) + "`"};
  }

  bool changes(const hir::Expr& e) {
    if (e.kind == hir::ExprKind::kMutate) place(e.as<hir::MutateExpr>().place);
    if (e.kind == hir::ExprKind::kCallNative) {
      const NativeFunction& called = *e.as<hir::CallNativeExpr>().function;
      const bool gives_nothing = called.gives != nullptr && e.type->is(Kind::kVoid);
      if (called.acts || called.commands || gives_nothing) found_ = Change{e.span};
    }
    return found_.has_value();
  }

  const hir::Function& function_;
  Changes of_;
  std::optional<Change> found_{};
};

void report_change(Checker& checker, Span condition, const Change& change) {
  Diagnostic diagnostic = make_diagnostic("E0533", condition);
  diagnostic.why = "it is evaluated at every tick and once more before the task goes on";
  if (!change.what.empty()) {
    diagnostic.why = "line " + std::to_string(checker.line_of(change.span)) + " changes " +
                     change.what + "; a condition " + diagnostic.why.substr(3);
  }
  diagnostic.fix = Fix{
      "only compare here, and change it after the condition has come true", {}, Confidence::kMaybe};
  checker.report(std::move(diagnostic));
}

}  // namespace

std::optional<Change> ChangeFinder::find(const hir::Function* function) {
  if (const auto found = known_.find(function); found != known_.end()) return found->second;
  // The functions from the first one to the change, each with the one that uses it.
  struct Step {
    const hir::Function* function;
    std::size_t from;
  };
  std::vector<Step> steps{{function, 0}};
  known_[function] = std::nullopt;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    std::optional<Change> change = Search(*steps[i].function, of_).run();
    for (const hir::Function* called : checker_.shared.uses.of(steps[i].function).calls) {
      if (change) break;
      const auto [known, is_new] = known_.try_emplace(called);
      if (is_new) steps.push_back({called, i});
      change = known->second;
    }
    if (!change) continue;
    // The search ended early, so the other functions were searched only in part and are searched
    // again.
    for (const Step& step : steps) known_.erase(step.function);
    for (std::size_t at = i;; at = steps[at].from) {
      known_[steps[at].function] = change;
      if (at == 0) return change;
    }
  }
  return std::nullopt;
}

void check_condition_changes(Checker& checker) {
  ChangeFinder finder(checker, Changes::kAll);
  for (const auto& [function, span] : checker.shared.postponed.conditions()) {
    if (is_sample(*function)) continue;
    if (checker.shared.uses.may_pause(checker.shared.uses.of(function))) continue;
    const auto change = finder.find(function);
    if (!change) continue;
    checker.messages.begin_statement();
    report_change(checker, span, *change);
  }
}

void check_callbacks(Checker& checker) {
  ChangeFinder finder(checker, Changes::kOfLibrary);
  for (const Postponed::Callback& callback : checker.shared.postponed.callbacks()) {
    if (!checker.shared.uses.may_pause(checker.shared.uses.of(callback.function))) {
      if (!callback.is_read || !finder.find(callback.function)) continue;
      checker.messages.begin_statement();
      checker.report(make_diagnostic("E0520", callback.span,
                                     {std::string(callback.called_by), "change anything"}));
      continue;
    }
    checker.messages.begin_statement();
    checker.report(
        make_diagnostic("E0520", callback.span,
                        {std::string(callback.called_by), what_takes_time(checker.registry)}));
  }
}

}  // namespace armlet::lang
