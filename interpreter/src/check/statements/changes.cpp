#include "check/statements/changes.hpp"

#include <unordered_set>
#include <vector>

#include "check/statements/recordings.hpp"
#include "check/tree/walk.hpp"

namespace armlet::lang {

namespace {

// Lists, structs and maps are values, so only a variable that lives on can carry a change outside.
bool outlives(const hir::Variable& variable, const hir::Function& function) {
  return variable.owner != &function || variable.outer != nullptr;
}

// Looks through the text of one function.
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

std::optional<Change> first_change(Checker& checker, const hir::Function* function, Changes of) {
  std::unordered_set<const hir::Function*> known{function};
  std::vector<const hir::Function*> open{function};
  while (!open.empty()) {
    const hir::Function* next = open.back();
    open.pop_back();
    if (auto change = Search(*next, of).run()) return change;
    for (const hir::Function* called : checker.shared.uses.of(next).calls)
      if (known.insert(called).second) open.push_back(called);
  }
  return std::nullopt;
}

void check_condition_changes(Checker& checker) {
  for (const auto& [function, span] : checker.shared.postponed.conditions()) {
    if (is_sample(*function)) continue;
    if (checker.shared.uses.may_pause(checker.shared.uses.of(function))) continue;
    const auto change = first_change(checker, function);
    if (!change) continue;
    checker.messages.begin_statement();
    report_change(checker, span, *change);
  }
}

}  // namespace armlet::lang
