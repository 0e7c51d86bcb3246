#include "check/statements/loop_advice.hpp"

#include <cmath>

namespace armlet::lang {
namespace {

// The parts of for (var y = a; y < b; y += c) that are arguments of `range`.
struct SteppedLoop {
  const ast::Name* name;
  const ast::Expr* first;
  const ast::BinaryExpr* test;
  const ast::AssignStmt* step;
};

bool is_called(const ast::Expr& expr, std::string_view name) {
  return expr.kind == ast::ExprKind::kName && expr.as<ast::NameExpr>().name == name;
}

std::optional<SteppedLoop> stepped_loop(const ast::ForStmt& loop) {
  const bool has_parts = loop.init.size() == 1 && loop.step.size() == 1 &&
                         loop.condition != nullptr && loop.init[0]->kind == ast::StmtKind::kVar &&
                         loop.step[0]->kind == ast::StmtKind::kAssign &&
                         loop.condition->kind == ast::ExprKind::kBinary;
  if (!has_parts) return std::nullopt;
  const auto& declared = loop.init[0]->as<ast::VarStmt>();
  const auto& step = loop.step[0]->as<ast::AssignStmt>();
  const auto& test = loop.condition->as<ast::BinaryExpr>();
  const bool is_simple = declared.declarators.size() == 1 &&
                         declared.declarators[0].init != nullptr && step.compound &&
                         step.op == ast::BinaryOp::kAdd && step.targets.size() == 1;
  if (!is_simple) return std::nullopt;
  const ast::Name& name = declared.declarators[0].name;
  const bool compares = test.op == ast::BinaryOp::kLess || test.op == ast::BinaryOp::kLessEq;
  if (!compares || !is_called(*step.targets[0], name.text) || !is_called(*test.left, name.text))
    return std::nullopt;
  return SteppedLoop{&name, declared.declarators[0].init, &test, &step};
}

// Whether the text is a number with a fraction: 0.1, but not 2.0 and not a computed value.
bool has_fraction(const std::string& text) {
  const char* const begin = text.c_str();
  char* end = nullptr;
  const double number = std::strtod(begin, &end);
  return end == begin + text.size() && number != std::floor(number);
}

}  // namespace

void advise_summed_steps(Checker& checker, const ast::ForStmt& loop) {
  const std::optional<SteppedLoop> parts = stepped_loop(loop);
  if (!parts) return;
  FunctionContext* where = nullptr;
  const Local* local = checker.scopes.find(parts->name->text, where);
  if (local == nullptr) return;
  const Type& type = *local->variable->type;
  const std::string step = checker.text_of(parts->step->value->span);
  if (!type.is_quantity() && !(type.is_double() && has_fraction(step))) return;
  Diagnostic out = make_diagnostic("W0754", parts->step->span, {std::string(parts->name->text)});
  out.why =
      "each step is rounded a little, so the loop may run once too often or miss its last value";
  const bool with_end = parts->test->op == ast::BinaryOp::kLessEq;
  const std::string end =
      checker.text_of(parts->test->right->span) + (with_end ? " + " + step + " / 2" : "");
  const std::string meant = std::string(parts->name->text) + " in range(" +
                            checker.text_of(parts->first->span) + ", " + end + ", " + step + ")";
  const Span header{loop.init[0]->span.begin, parts->step->span.end, loop.span.source};
  out.fix = Fix{.text = "write for (" + meant + ")",
                .edits = {{header, meant}},
                .confidence = Confidence::kMaybe};
  checker.report(std::move(out));
}

}  // namespace armlet::lang
