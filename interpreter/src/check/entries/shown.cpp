#include "check/entries/shown.hpp"

#include <utility>

#include "check/library/explained.hpp"
#include "check/names/variables.hpp"
#include "check/statements/statements.hpp"

namespace armlet::lang {
namespace {

constexpr std::string_view kAnswer = "ans";

bool has_semicolon(const Checker& checker, std::uint32_t behind, std::uint32_t source) {
  const std::string_view rest = (*checker.into.sources)[source].text().substr(behind);
  const std::size_t next = rest.find_first_not_of(" \t");
  return next != std::string_view::npos && rest[next] == ';';
}

bool has_known_elements(const Type* type) {
  while (type->is(Kind::kList) || type->is(Kind::kMap)) type = type->element;
  return !type->is(Kind::kAny);
}

hir::Stmt* keep_answer(Checker& checker, const ast::Stmt& stmt, hir::Expr* value, Use used) {
  hir::Variable* answer = new_variable(checker, kAnswer, value->type, value->span);
  answer->fixed = true;
  answer->init = value;
  auto* init = checker.make<hir::InitStmt>(hir::StmtKind::kInit, stmt.span, answer, value);
  checker.shared.top_level.add(answer, init, std::move(used));
  checker.into.entry.shown = {answer, false,
                              has_semicolon(checker, value->span.end, stmt.span.source)};
  return init;
}

void show_declared(Checker& checker, const ast::VarStmt& stmt) {
  if (stmt.declarators.size() != 1 || stmt.declarators[0].init == nullptr) return;
  const ast::Declarator& declarator = stmt.declarators[0];
  for (const TopLevel::Entry& entry : checker.shared.top_level.entries()) {
    if (entry.variable->declared == declarator.name.span)
      checker.into.entry.shown = {
          entry.variable, true,
          has_semicolon(checker, declarator.init->span.end, stmt.span.source)};
  }
}

}  // namespace

hir::Stmt* check_last(Checker& checker, const ast::Stmt& stmt) {
  if (stmt.kind == ast::StmtKind::kVar) {
    hir::Stmt* declared = checker.check_statement(stmt);
    show_declared(checker, stmt.as<ast::VarStmt>());
    return declared;
  }
  if (stmt.kind != ast::StmtKind::kExpr || !is_value_statement(checker, stmt.as<ast::ExprStmt>()))
    return checker.check_statement(stmt);
  checker.messages.begin_statement();
  const ast::ExprStmt& written = stmt.as<ast::ExprStmt>();
  Use used;
  Use& before = checker.scopes.collect_in(used);
  hir::Expr* value = checker.check(*written.value);
  if (hir::Expr* explained = shown_explanation(checker, written, value)) value = explained;
  checker.scopes.collect_in(before);
  if (value->type->is(Kind::kAny)) return nullptr;
  if (!value->type->is(Kind::kVoid) && has_known_elements(value->type))
    return keep_answer(checker, stmt, value, std::move(used));
  before.add(used);
  return checker.make<hir::ExprStmt>(hir::StmtKind::kExpr, stmt.span, value);
}

}  // namespace armlet::lang
