// switch: each case is a list of tests and a block of its own.

#include <algorithm>

#include "check/checker.hpp"
#include "check/explain/edits.hpp"

namespace armlet::lang {
namespace {

// The last statement that is not just a `;`.
const ast::Stmt* last_statement(ast::Seq<ast::Stmt*> body) {
  for (std::size_t i = body.size(); i-- > 0;) {
    if (body[i]->kind != ast::StmtKind::kEmpty) return body[i];
  }
  return nullptr;
}

}  // namespace

// subject == value, with `value` written in the text. Notes what was compared with, to find what is
// missing or double.
hir::Expr* Checker::case_test(hir::Variable* subject, const ast::Expr& value,
                              std::set<std::string>& seen) {
  hir::Expr* wanted =
      require(check_value(value, subject->type), {.type = subject->type, .name = "case"});
  if (wanted->type->is(Kind::kAny)) return wanted;
  std::string shown = text_of(value.span);
  if (wanted->kind == hir::ExprKind::kEnum) {
    shown = wanted->type->enumeration
                ->values[static_cast<std::size_t>(wanted->as<hir::IntExpr>().value)];
  } else if (const auto constant = constant_of(*wanted)) {
    if (constant->kind == Constant::Kind::kInt) shown = std::to_string(constant->integer);
    if (constant->kind == Constant::Kind::kText) shown = '"' + constant->text + '"';
  } else {
    report(make_diagnostic("E0334", value.span, {"a case", "a value written in the text"}));
    return failed(value.span);
  }
  if (!seen.insert(shown).second) {
    report(make_diagnostic("E0329", value.span, {text_of(value.span)}));
    return failed(value.span);
  }
  hir::Expr* left =
      make<hir::VariableExpr>(hir::ExprKind::kVariable, subject->type, value.span, subject);
  const hir::Op op = subject->type->is(Kind::kText) ? hir::Op::kEqText : hir::Op::kEqI;
  return make<hir::BinaryExpr>(hir::ExprKind::kBinary, types_.boolean(), value.span, op, left,
                               wanted, value.span);
}

hir::Stmt* Checker::check_switch(const ast::SwitchStmt& stmt) {
  auto* out = make<hir::SwitchStmt>(hir::StmtKind::kSwitch, stmt.span, nullptr, nullptr,
                                    hir::Seq<hir::SwitchCase>{});
  out->value = check_value(*stmt.value);
  const Type* type = out->value->type;
  if (!type->is(Kind::kInt) && !type->is(Kind::kText) && !type->is(Kind::kEnum) &&
      !type->is(Kind::kAny)) {
    report(make_diagnostic("E0315", out->value->span,
                           {"an int, a text or an enum value", type_phrase(type)}));
    type = types_.any();
  }
  out->subject = hidden(type, stmt.value->span);
  const Flow before = here_->flow;
  std::vector<Flow> ways;  // out of each case
  bool has_default = false;
  std::set<std::string> seen;
  std::vector<hir::SwitchCase> cases;
  std::vector<hir::Expr*> tests;
  bool is_default = false;
  here_->targets.push_back({JumpTarget::Kind::kSwitch, out});
  for (std::size_t i = 0; i < stmt.cases.size(); ++i) {
    const ast::SwitchCase& at = stmt.cases[i];
    sink_.begin_statement();
    for (const ast::Expr* value : at.values) tests.push_back(case_test(out->subject, *value, seen));
    is_default = is_default || at.is_default;
    // Cases without statements share the next body.
    if (last_statement(at.body) == nullptr && i + 1 < stmt.cases.size()) continue;
    here_->flow = before;
    hir::Block* body = check_block(at.body, at.span);
    ways.push_back(here_->flow);
    cases.push_back({seq(tests), is_default, body});
    has_default = has_default || is_default;
    tests.clear();
    is_default = false;
  }
  const bool complete = type->is(Kind::kEnum) && seen.size() == type->enumeration->values.size();
  if (!has_default && !complete) ways.push_back(before);
  Flow after = merged(std::move(ways));
  after.merge(merged(std::move(here_->targets.back().exits)));
  here_->targets.pop_back();
  here_->flow = std::move(after);
  sink_.begin_statement();
  if (type->is(Kind::kEnum) && !has_default && !complete) missing_cases(stmt, type, seen);
  advise_missing_break(stmt);
  out->cases = seq(cases);
  return out;
}

void Checker::missing_cases(const ast::SwitchStmt& stmt, const Type* type,
                            const std::set<std::string>& seen) {
  if (!takes_errors()) return report(make_diagnostic("E0307", stmt.header, {""}));
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
  const std::string text = text_of(header);
  header.end = header.begin + static_cast<std::uint32_t>(text.find_last_of(')') + 1);
  Diagnostic diagnostic = make_diagnostic("E0307", header, {list});
  diagnostic.why = "every value of an enum must be handled";
  const Span brace{stmt.span.end - 1, stmt.span.end, stmt.span.source};
  diagnostic.fix = Fix{.text = "add case " + cases + ": or default:",
                       .edits = {at_end_of_block(*this, brace, "case " + cases + ":")}};
  report(std::move(diagnostic));
}

// In Java a case without break runs on; a program that writes break elsewhere may have meant that.
void Checker::advise_missing_break(const ast::SwitchStmt& stmt) {
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
    report(make_diagnostic("W0713", stmt.cases[i].span));
    return;
  }
}

}  // namespace armlet::lang
