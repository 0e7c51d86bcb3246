#include "check/statements/switches.hpp"

#include <algorithm>

#include "check/explain/edits.hpp"
#include "check/names/variables.hpp"
#include "check/state/checker.hpp"

namespace armlet::lang {

namespace {

void missing_cases(Checker& checker, const ast::SwitchStmt& stmt, const Type* type,
                   const std::set<std::string>& seen);
void advise_missing_break(Checker& checker, const ast::SwitchStmt& stmt);

// The last statement that is not an empty `;`.
const ast::Stmt* last_statement(ast::Seq<ast::Stmt*> body) {
  for (std::size_t i = body.size(); i-- > 0;) {
    if (body[i]->kind != ast::StmtKind::kEmpty) return body[i];
  }
  return nullptr;
}

}  // namespace

// The test subject == value. Collects the values, to find missing and repeated ones.
namespace {

hir::Expr* case_test(Checker& checker, hir::Variable* subject, const ast::Expr& value,
                     std::set<std::string>& seen) {
  hir::Expr* wanted = checker.require(checker.check_value(value, subject->type),
                                      {.type = subject->type, .name = "case"});
  if (wanted->type->is(Kind::kAny)) return wanted;
  std::string shown = checker.text_of(value.span);
  if (wanted->kind == hir::ExprKind::kEnum) {
    shown = wanted->type->enumeration
                ->values[static_cast<std::size_t>(wanted->as<hir::IntExpr>().value)];
  } else if (const auto constant = checker.shared.constants.of(*wanted)) {
    if (constant->kind == Constant::Kind::kInt) shown = std::to_string(constant->integer);
    if (constant->kind == Constant::Kind::kText) shown = '"' + constant->text + '"';
  } else {
    checker.report(make_diagnostic("E0334", value.span, {"a case", "a value written in the text"}));
    return checker.failed(value.span);
  }
  if (!seen.insert(shown).second) {
    checker.report(make_diagnostic("E0329", value.span, {checker.text_of(value.span)}));
    return checker.failed(value.span);
  }
  hir::Expr* left =
      checker.make<hir::VariableExpr>(hir::ExprKind::kVariable, subject->type, value.span, subject);
  const hir::Op op = subject->type->is(Kind::kText) ? hir::Op::kEqText : hir::Op::kEqI;
  return checker.make<hir::BinaryExpr>(hir::ExprKind::kBinary, checker.types.boolean(), value.span,
                                       op, left, wanted, value.span);
}

}  // namespace

hir::Stmt* check_switch(Checker& checker, const ast::SwitchStmt& stmt) {
  auto* out = checker.make<hir::SwitchStmt>(hir::StmtKind::kSwitch, stmt.span, nullptr, nullptr,
                                            hir::Seq<hir::SwitchCase>{});
  out->value = checker.check_value(*stmt.value);
  const Type* type = out->value->type;
  if (!type->is(Kind::kInt) && !type->is(Kind::kText) && !type->is(Kind::kEnum) &&
      !type->is(Kind::kAny)) {
    checker.report(make_diagnostic("E0315", out->value->span,
                                   {"an int, a text or an enum value", type_phrase(type)}));
    type = checker.types.any();
  }
  out->subject = hidden(checker, type, stmt.value->span);
  const Flow before = checker.scopes.here().flow;
  std::vector<Flow> ways;  // at the end of each case
  bool has_default = false;
  std::set<std::string> seen;
  std::vector<hir::SwitchCase> cases;
  std::vector<hir::Expr*> tests;
  bool is_default = false;
  checker.scopes.here().targets.push_back({JumpTarget::Kind::kSwitch, out});
  for (std::size_t i = 0; i < stmt.cases.size(); ++i) {
    const ast::SwitchCase& at = stmt.cases[i];
    checker.messages.begin_statement();
    for (const ast::Expr* value : at.values)
      tests.push_back(case_test(checker, out->subject, *value, seen));
    is_default = is_default || at.is_default;
    // Cases without statements share the body of the next one.
    if (last_statement(at.body) == nullptr && i + 1 < stmt.cases.size()) continue;
    checker.scopes.here().flow = before;
    hir::Block* body = checker.check_block(at.body, at.span);
    ways.push_back(checker.scopes.here().flow);
    cases.push_back({checker.seq(tests), is_default, body});
    has_default = has_default || is_default;
    tests.clear();
    is_default = false;
  }
  const bool complete = type->is(Kind::kEnum) && seen.size() == type->enumeration->values.size();
  if (!has_default && !complete) ways.push_back(before);
  Flow after = merged(std::move(ways));
  after.merge(merged(std::move(checker.scopes.here().targets.back().exits)));
  checker.scopes.here().targets.pop_back();
  checker.scopes.here().flow = std::move(after);
  checker.messages.begin_statement();
  if (type->is(Kind::kEnum) && !has_default && !complete) missing_cases(checker, stmt, type, seen);
  advise_missing_break(checker, stmt);
  out->cases = checker.seq(cases);
  return out;
}

namespace {

void missing_cases(Checker& checker, const ast::SwitchStmt& stmt, const Type* type,
                   const std::set<std::string>& seen) {
  if (!checker.messages.takes_errors())
    return checker.report(make_diagnostic("E0307", stmt.header, {""}));
  std::vector<std::string> missing;
  for (const std::string& value : type->enumeration->values) {
    if (!seen.contains(value)) missing.push_back(type->enumeration->name + '.' + value);
  }
  std::string list;
  std::string cases;
  for (std::size_t i = 0; i < missing.size(); ++i) {
    list += (i == 0 ? "" : i + 1 < missing.size() ? ", " : " and ") + missing[i];
    cases += (i == 0 ? "" : ", ") + missing[i];
  }
  Span header = stmt.header;
  const std::string text = checker.text_of(header);
  header.end = header.begin + static_cast<std::uint32_t>(text.find_last_of(')') + 1);
  Diagnostic diagnostic = make_diagnostic("E0307", header, {list});
  diagnostic.why = "every value of an enum must be handled";
  const Span brace{stmt.span.end - 1, stmt.span.end, stmt.span.source};
  diagnostic.fix = Fix{.text = "add case " + cases + ": or default:",
                       .edits = {at_end_of_block(checker, brace, "case " + cases + ":")}};
  checker.report(std::move(diagnostic));
}

// In Java a case without break continues with the next one. A program with breaks in other cases
// may rely on it.
void advise_missing_break(Checker& checker, const ast::SwitchStmt& stmt) {
  const auto ends_with_break = [](const ast::SwitchCase& at) {
    const ast::Stmt* last = last_statement(at.body);
    return last != nullptr && last->kind == ast::StmtKind::kBreak;
  };
  if (std::ranges::none_of(stmt.cases, ends_with_break)) return;
  for (std::size_t i = 0; i + 1 < stmt.cases.size(); ++i) {
    const ast::Stmt* last = last_statement(stmt.cases[i].body);
    if (last == nullptr) continue;
    const bool leaves =
        last->kind == ast::StmtKind::kBreak || last->kind == ast::StmtKind::kReturn ||
        last->kind == ast::StmtKind::kThrow || last->kind == ast::StmtKind::kContinue ||
        last->kind == ast::StmtKind::kRetry;
    if (leaves) continue;
    checker.report(make_diagnostic("W0713", stmt.cases[i].span));
    return;
  }
}

}  // namespace

}  // namespace armlet::lang
