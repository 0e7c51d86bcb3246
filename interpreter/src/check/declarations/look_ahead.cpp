#include "check/declarations/look_ahead.hpp"

#include <algorithm>
#include <vector>

#include "ast/ast_walk.hpp"
#include "check/state/list_mutations.hpp"

namespace armlet::lang {
namespace {

class Lookout {
 public:
  explicit Lookout(Sights& sights) : sights_(sights) {}

  // Visits all parts without recursion, because programs may be nested deeply.
  void look_over(const ast::Stmt& program) {
    statements_.push_back(&program);
    while (!statements_.empty() || !expressions_.empty()) {
      const auto open_expr = [this](const ast::Expr& e) { expressions_.push_back(&e); };
      const auto open_stmt = [this](const ast::Stmt& s) { statements_.push_back(&s); };
      if (!expressions_.empty()) {
        const ast::Expr& at = *expressions_.back();
        expressions_.pop_back();
        note(at);
        for_each_part(at, open_expr, open_stmt);
      } else {
        const ast::Stmt& at = *statements_.back();
        statements_.pop_back();
        note(at);
        for_each_part(at, open_expr, open_stmt);
      }
    }
  }

 private:
  void changes(const ast::Expr* place) {
    for (;;) {
      if (place->kind == ast::ExprKind::kMember) {
        place = place->as<ast::MemberExpr>().object;
      } else if (place->kind == ast::ExprKind::kIndex) {
        place = place->as<ast::IndexExpr>().object;
      } else {
        break;
      }
    }
    if (place->kind == ast::ExprKind::kName)
      sights_.changed.insert(place->as<ast::NameExpr>().name);
  }

  void note(const ast::Expr& at) {
    if (at.kind == ast::ExprKind::kName) {
      sights_.mentioned.insert(at.as<ast::NameExpr>().name);
    } else if (at.kind == ast::ExprKind::kMember) {
      sights_.mentioned.insert(at.as<ast::MemberExpr>().member.text);
    } else if (at.kind == ast::ExprKind::kCall) {
      const ast::Expr& callee = *at.as<ast::CallExpr>().callee;
      if (callee.kind != ast::ExprKind::kMember) return;
      const std::string_view name = callee.as<ast::MemberExpr>().member.text;
      const bool of_list = std::ranges::find(kListMutations, name, &ListMutation::name) !=
                           std::ranges::end(kListMutations);
      if (of_list || name == "remove")
        changes(callee.as<ast::MemberExpr>().object);  // m.remove(key)
    }
  }

  void note(const ast::Stmt& at) {
    if (at.kind == ast::StmtKind::kAssign) {
      for (const ast::Expr* target : at.as<ast::AssignStmt>().targets) changes(target);
    } else if (at.kind == ast::StmtKind::kStep) {
      changes(at.as<ast::StepStmt>().target);
    } else if (at.kind == ast::StmtKind::kVar) {
      // The first assignment to a variable without a first value is a change.
      for (const ast::Declarator& declarator : at.as<ast::VarStmt>().declarators)
        if (declarator.init == nullptr) sights_.changed.insert(declarator.name.text);
    } else if (at.kind == ast::StmtKind::kWith) {
      for (const ast::Arg& setting : at.as<ast::WithStmt>().settings)
        sights_.settings.insert(setting.name.text);
    }
  }

  Sights& sights_;
  std::vector<const ast::Expr*> expressions_;
  std::vector<const ast::Stmt*> statements_;
};

// Whether a `return` inside of the statement belongs to another function or to a task.
bool holds_other_returns(const ast::Stmt& at) {
  return at.kind == ast::StmtKind::kFunction || at.kind == ast::StmtKind::kTest ||
         at.kind == ast::StmtKind::kParallel || at.kind == ast::StmtKind::kWhen ||
         at.kind == ast::StmtKind::kEvery;
}

}  // namespace

bool returns_a_value(const ast::Block& body) {
  std::vector<const ast::Stmt*> open{&body};
  while (!open.empty()) {
    const ast::Stmt& at = *open.back();
    open.pop_back();
    if (at.kind == ast::StmtKind::kReturn && at.as<ast::ReturnStmt>().value != nullptr) return true;
    if (holds_other_returns(at)) continue;
    for_each_part(
        at, [](const ast::Expr&) {}, [&](const ast::Stmt& child) { open.push_back(&child); });
  }
  return false;
}

Sights look_over(const ast::Block& program) {
  Sights out;
  Lookout(out).look_over(program);
  return out;
}

}  // namespace armlet::lang
