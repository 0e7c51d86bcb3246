#include "check/statements/idle.hpp"

#include <algorithm>
#include <array>

namespace armlet::lang {

bool does_nothing(const hir::Expr& value) {
  using hir::ExprKind;
  constexpr std::array kActive = {ExprKind::kCall, ExprKind::kCallValue, ExprKind::kCallNative,
                                  ExprKind::kMutate, ExprKind::kGuarded};
  if (std::ranges::find(kActive, value.kind) != kActive.end()) return false;
  if (value.kind == ExprKind::kCond)
    return does_nothing(*value.as<hir::CondExpr>().yes) &&
           does_nothing(*value.as<hir::CondExpr>().no);
  if (value.kind == ExprKind::kConvert) return does_nothing(*value.as<hir::ConvertExpr>().operand);
  return !value.type->is(Kind::kAny);
}

void refuse_idle_statement(Checker& checker, const ast::ExprStmt& stmt, const hir::Expr& value) {
  Diagnostic diagnostic = make_diagnostic("E0332", stmt.value->span);
  const FunctionContext& here = checker.scopes.here();
  const std::string text = checker.text_of(stmt.value->span);
  const Span begin{stmt.span.begin, stmt.span.begin, stmt.span.source};
  const Span end{stmt.value->span.end, stmt.value->span.end, stmt.value->span.source};
  if (value.kind == hir::ExprKind::kFunctionValue) {
    diagnostic.fix = Fix{.text = "write " + text + "()", .edits = {{end, "()"}}};
  } else if (here.result_is_declared && here.result == value.type) {
    diagnostic.why = "a value is given back by `return`";
    diagnostic.fix = Fix{.text = "write return " + text, .edits = {{begin, "return "}}};
    checker.scopes.here().flow.reachable = false;  // no second message about the missing return
  }
  checker.report(std::move(diagnostic));
}

void advise_forgotten_value(Checker& checker, const ast::ExprStmt& stmt, const hir::Expr& value) {
  if (value.kind != hir::ExprKind::kCallNative || value.type->is(Kind::kVoid)) return;
  const auto& call = value.as<hir::CallNativeExpr>();
  FunctionContext& here = checker.scopes.here();
  const bool may_probe = here.tries > 0 || here.kind == FunctionContext::Kind::kLambda ||
                         here.kind == FunctionContext::Kind::kCondition;
  if (may_probe || !checker.registry.only_gives(*call.function)) return;
  if (std::ranges::any_of(call.arguments, [](const hir::Expr* argument) {
        return argument != nullptr && argument->type->is(Kind::kFunction);
      }))
    return;
  Diagnostic diagnostic =
      make_diagnostic("W0746", stmt.value->span, {std::string(call.function->name)});
  diagnostic.why = "it changes nothing; it gives " + type_phrase(value.type);
  const hir::Expr* first = call.arguments.size() > 0 ? call.arguments[0] : nullptr;
  const std::string name = first != nullptr ? checker.text_of(first->span) : std::string();
  const Local* local = name.empty() ? nullptr : here.find(name);
  const bool is_variable =
      local != nullptr && (local->how == Declared::kVar || local->how == Declared::kClassic);
  if (is_variable && local->variable->type == value.type) {
    const Span begin{stmt.value->span.begin, stmt.value->span.begin, stmt.value->span.source};
    diagnostic.fix = Fix{.text = "write " + name + " = " + checker.text_of(stmt.value->span),
                         .edits = {{begin, name + " = "}},
                         .confidence = Confidence::kMaybe};
  }
  checker.report(std::move(diagnostic));
}

}  // namespace armlet::lang
