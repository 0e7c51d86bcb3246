#include "check/expressions/expressions.hpp"

#include <algorithm>

#include "ast/ast_walk.hpp"
#include "base/cancelled.hpp"
#include "check/calls/calls.hpp"
#include "check/explain/joined_lines.hpp"
#include "check/expressions/matrices.hpp"
#include "check/expressions/members.hpp"
#include "check/expressions/new_structs.hpp"
#include "check/expressions/operators.hpp"
#include "check/functions/function_names.hpp"
#include "check/functions/functions.hpp"
#include "check/functions/lambdas.hpp"
#include "check/library/formatted.hpp"
#include "check/names/reading.hpp"
#include "check/names/unknown_names.hpp"
#include "check/state/checker.hpp"
#include "check/state/learnt.hpp"
#include "check/types/maps.hpp"
#include "check/types/mismatch.hpp"
#include "check/types/types.hpp"
#include "hir/zero.hpp"

namespace armlet::lang {

namespace {

hir::Expr* check_any(Checker& checker, const ast::Expr& expr, const Type* expected);
hir::Expr* check_literal(Checker& checker, const ast::Expr& expr);
hir::Expr* check_name(Checker& checker, const ast::NameExpr& name, const Type* expected);
hir::Expr* check_conditional(Checker& checker, const ast::CondExpr& cond, const Type* expected);
hir::Expr* check_list(Checker& checker, const ast::Expr& expr, ast::Seq<ast::Expr*> items,
                      const Type* expected);
hir::Expr* check_new_array(Checker& checker, const ast::NewArrayExpr& expr);
hir::Expr* check_until(Checker& checker, const ast::UntilExpr& until);

}  // namespace

namespace {

void learn_part(Checker& checker, const ast::Expr& part) {
  if (checker.shared.learnt->has_met(part)) return;
  if (part.kind != ast::ExprKind::kLambda) {
    checker.check(part);
    return;
  }
  // The types of its arguments are unknown.
  const std::vector<const Type*> types(part.as<ast::LambdaExpr>().params.size(),
                                       checker.types.any());
  checker.check(part, checker.types.function(types, checker.types.any()));
}

// For editors: checks the parts of a failed expression that were not checked.
void learn_rest(Checker& checker, const ast::Expr& expr) {
  if (expr.kind == ast::ExprKind::kLambda) return;
  const ast::Expr* callee =
      expr.kind == ast::ExprKind::kCall ? expr.as<ast::CallExpr>().callee : nullptr;
  // The name of a called function is not a value.
  if (callee != nullptr && callee->kind == ast::ExprKind::kMember)
    learn_part(checker, *callee->as<ast::MemberExpr>().object);
  ast::for_each_part(
      expr,
      [&](const ast::Expr& part) {
        if (&part != callee) learn_part(checker, part);
      },
      [](const ast::Stmt&) {});
}

}  // namespace

void learn_targets(Checker& checker, const ast::Stmt& stmt) {
  if (!checker.shared.guesses) return;
  ast::for_each_part(
      stmt, [&](const ast::Expr& part) { learn_part(checker, part); }, [](const ast::Stmt&) {});
}

hir::Expr* Checker::check(const ast::Expr& expr, const Type* expected) {
  stop_if(options.cancelled);
  if (shared.depth.is_full()) {
    report(make_diagnostic("E0125", expr.span, {std::to_string(Depth::kMost) + " levels"}));
    return failed(expr.span);
  }
  const Joined joined = joined_line(*this, expr);
  if (!joined.bracket.empty()) messages.open(joined);
  const Depth::Level level(shared.depth);
  hir::Expr* out = check_any(*this, expr, expected);
  if (shared.guesses && (out->type->is(Kind::kAny) || out->kind == hir::ExprKind::kAbsent))
    learn_rest(*this, expr);
  if (shared.learnt != nullptr) shared.learnt->value(expr, *out);
  if (!joined.bracket.empty()) messages.close_joined();
  return out;
}

hir::Expr* Checker::check_value(const ast::Expr& expr, const Type* expected) {
  hir::Expr* value = check(expr, expected);
  if (!value->type->is(Kind::kVoid)) return value;
  return mismatch(*this, *value, {.type = types.any()});
}

namespace {

hir::Expr* check_any(Checker& checker, const ast::Expr& expr, const Type* expected) {
  using ast::ExprKind;
  switch (expr.kind) {
    case ExprKind::kInt:
    case ExprKind::kReal:
    case ExprKind::kQuantity:
    case ExprKind::kText:
    case ExprKind::kBool:
      return check_literal(checker, expr);
    case ExprKind::kFormatted:
      return check_formatted(checker, expr.as<ast::FormattedExpr>());
    case ExprKind::kName:
      return check_name(checker, expr.as<ast::NameExpr>(), expected);
    case ExprKind::kMember:
      return check_member(checker, expr.as<ast::MemberExpr>(), expected);
    case ExprKind::kIndex:
      return check_index(checker, expr.as<ast::IndexExpr>());
    case ExprKind::kCall:
      return check_call(checker, expr.as<ast::CallExpr>(), expected);
    case ExprKind::kUnary:
      return check_unary(checker, expr.as<ast::UnaryExpr>(), expected);
    case ExprKind::kBinary:
      return check_binary(checker, expr.as<ast::BinaryExpr>(), expected);
    case ExprKind::kCond:
      return check_conditional(checker, expr.as<ast::CondExpr>(), expected);
    case ExprKind::kCast: {
      const auto& node = expr.as<ast::CastExpr>();
      return cast(checker, checker.check_value(*node.operand), type_called(checker, node.type.text),
                  expr.span);
    }
    case ExprKind::kList:
      return check_list(checker, expr, expr.as<ast::ListExpr>().items, expected);
    case ExprKind::kBrace:
      return check_list(checker, expr, expr.as<ast::BraceExpr>().items, expected);
    case ExprKind::kMap:
      return check_map(checker, expr.as<ast::MapExpr>(), expected);
    case ExprKind::kMatrix:
      return check_matrix(checker, expr.as<ast::MatrixExpr>());
    case ExprKind::kNewObject:
      return check_new_object(checker, expr.as<ast::NewObjectExpr>());
    case ExprKind::kNewArray:
      return check_new_array(checker, expr.as<ast::NewArrayExpr>());
    case ExprKind::kLambda:
      return check_lambda(checker, expr.as<ast::LambdaExpr>(), expected);
    case ExprKind::kUntil:
      return check_until(checker, expr.as<ast::UntilExpr>());
  }
  return checker.failed(expr.span);
}

hir::Expr* check_literal(Checker& checker, const ast::Expr& expr) {
  using ast::ExprKind;
  if (expr.kind == ExprKind::kInt) {
    const auto& node = expr.as<ast::IntExpr>();
    if (!node.too_large)
      return checker.make<hir::IntExpr>(hir::ExprKind::kInt, checker.types.integer(), expr.span,
                                        node.value);
    checker.report(make_diagnostic("E0109", expr.span, {checker.text_of(expr.span)}));
    return checker.failed(expr.span);
  }
  if (expr.kind == ExprKind::kReal)
    return checker.make<hir::RealExpr>(hir::ExprKind::kReal, checker.types.real(), expr.span,
                                       expr.as<ast::RealExpr>().value);
  if (expr.kind == ExprKind::kQuantity) {
    const auto& node = expr.as<ast::QuantityExpr>();
    return checker.make<hir::RealExpr>(hir::ExprKind::kReal, checker.types.quantity(node.dim),
                                       expr.span, node.si);
  }
  if (expr.kind == ExprKind::kText) {
    const std::string_view text = checker.arena.copy(expr.as<ast::TextExpr>().value);
    return checker.make<hir::TextExpr>(hir::ExprKind::kText, checker.types.text(), expr.span, text);
  }
  return checker.make<hir::BoolExpr>(hir::ExprKind::kBool, checker.types.boolean(), expr.span,
                                     expr.as<ast::BoolExpr>().value);
}

}  // namespace

// ---- names -------------------------------------------------------------------------------------

namespace {

hir::Expr* check_name(Checker& checker, const ast::NameExpr& name, const Type* expected) {
  FunctionContext* where = nullptr;
  if (Local* local = checker.scopes.find(name.name, where))
    return read(checker, *local, *where, name.span);
  if (FunctionDecl* function = checker.names.find_function(name.name))
    return function_value(checker, *function, expected, name.span);
  if (const NativeConstant* constant = checker.registry.constant(name.name)) {
    checker.shared.mentions.add(name.name);
    return checker.make<hir::RealExpr>(hir::ExprKind::kReal, checker.types.quantity(constant->dim),
                                       name.span, constant->value);
  }
  if (hir::Expr* value = library_function_value(checker, name, name.name, expected)) return value;
  const bool is_group = checker.registry.is_namespace(name.name) || name.name == "Math";
  const char* what = checker.names.find_import(name.name) != nullptr  ? "module"
                     : is_group                                       ? "group of functions"
                     : type_called(checker, name.name) != nullptr     ? "type"
                     : !checker.registry.functions(name.name).empty() ? "function of the library"
                                                                      : nullptr;
  if (what == nullptr) return unknown_name(checker, name.name, name.span, expected);
  if (!checker.messages.is_news(name.name)) return checker.failed(name.span);
  Diagnostic diagnostic = make_diagnostic("E0219", name.span, {std::string(name.name), what});
  const auto works_alone = [&](const NativeFunction* function) {
    const auto& parameters = checker.shared.signatures.of(*function).parameters;
    return std::ranges::all_of(parameters, [&](const Parameter& parameter) {
      const bool ambient = &parameter == parameters.data() && parameter.type.type != nullptr &&
                           parameter.type.type->is(Kind::kHost) &&
                           parameter.type.type->host->is_ambient;
      return ambient || parameter.may_be_left_out();
    });
  };
  if (std::ranges::any_of(checker.registry.functions(name.name), works_alone)) {
    const Span behind{name.span.end, name.span.end, name.span.source};
    diagnostic.fix =
        Fix{.text = "write " + std::string(name.name) + "()", .edits = {{behind, "()"}}};
  } else if (const std::string lambda = lambda_around(checker, name.name);
             !lambda.empty() && !(checker.surroundings.is_named(name.span))) {
    diagnostic.fix = Fix{.text = "write " + lambda, .edits = {{name.span, lambda}}};
  }
  checker.report(std::move(diagnostic));
  return checker.failed(name.span);
}

}  // namespace

// ---- values made of values ---------------------------------------------------------------------

namespace {

hir::Expr* check_conditional(Checker& checker, const ast::CondExpr& cond, const Type* expected) {
  hir::Expr* condition_value = checker.condition(*cond.condition);
  hir::Expr* yes = checker.check_value(*cond.yes, expected);
  hir::Expr* no = checker.check_value(*cond.no, expected);
  if (yes->type->is(Kind::kAny) != no->type->is(Kind::kAny))
    return checker.guessed(cond.span, yes->type->is(Kind::kAny) ? no->type : yes->type);
  const Type* type = common_type(checker, *yes, *no);
  hir::Expr* left = type != nullptr ? checker.convert(yes, type) : nullptr;
  hir::Expr* right = type != nullptr ? checker.convert(no, type) : nullptr;
  if (left == nullptr || right == nullptr) {
    Diagnostic diagnostic =
        make_diagnostic("E0311", no->span, {type_phrase(yes->type), type_phrase(no->type)});
    diagnostic.mark.label = type_name(no->type);
    diagnostic.related.push_back({yes->span, type_name(yes->type)});
    checker.report(std::move(diagnostic));
    return checker.failed(cond.span);
  }
  return checker.make<hir::CondExpr>(hir::ExprKind::kCond, type, cond.span, condition_value, left,
                                     right);
}

hir::Expr* check_list(Checker& checker, const ast::Expr& expr, ast::Seq<ast::Expr*> items,
                      const Type* expected) {
  if (items.empty() && expr.kind == ast::ExprKind::kBrace && expected != nullptr &&
      expected->is(Kind::kMap))
    return empty_map(checker, expected, expr.span);
  const Type* wanted =
      expected != nullptr && expected->is(Kind::kList) ? expected->element : nullptr;
  std::vector<hir::Expr*> values;
  const Type* element = nullptr;
  hir::Expr* widest = nullptr;
  for (const ast::Expr* item : items) {
    hir::Expr* value = checker.check_value(*item, wanted);
    if (value->type->is(Kind::kAny) && !checker.shared.guesses) return checker.failed(expr.span);
    if (value->type->is(Kind::kAny)) continue;  // its type follows from the other elements
    values.push_back(value);
    if (wanted != nullptr) continue;
    element = widest == nullptr ? values[0]->type : common_type(checker, *widest, *values.back());
    if (element == nullptr) {
      Diagnostic diagnostic =
          make_diagnostic("E0330", values.back()->span,
                          {type_phrase(widest->type), type_phrase(values.back()->type)});
      diagnostic.why = namesakes(widest->type, values.back()->type);
      checker.report(std::move(diagnostic));
      return checker.failed(expr.span);
    }
    if (widest == nullptr || element != widest->type) widest = values.back();
  }
  if (wanted != nullptr) {
    // The whole list keeps its own types if the target needs others, so that the message is about
    // the target.
    for (hir::Expr*& value : values) {
      value = checker.require(value, {.role = Target::Role::kElement, .type = wanted});
      if (value->type->is(Kind::kAny)) return checker.failed(expr.span);
    }
    element = wanted;
  } else {
    for (hir::Expr*& value : values) {
      if (hir::Expr* same = checker.convert(value, element)) value = same;
    }
  }
  if (element == nullptr) element = checker.types.any();
  return checker.make<hir::ListExpr>(hir::ExprKind::kList, checker.types.list(element), expr.span,
                                     checker.seq(values));
}

hir::Expr* check_new_array(Checker& checker, const ast::NewArrayExpr& expr) {
  const Type* type = checker.resolve(*expr.element);
  if (type->is(Kind::kAny)) return checker.failed(expr.span);
  const Type* innermost = type;
  for (int i = 0; i < expr.open_dimensions; ++i) type = checker.types.list(type);
  if (expr.init != nullptr)
    return check_list(checker, *expr.init, expr.init->as<ast::BraceExpr>().items, type);
  if (expr.open_dimensions == 0) {
    if (hir::Expr* list = new_structs(checker, expr, innermost)) return list;
  }
  if (expr.open_dimensions == 0 && !has_zero(*innermost))
    checker.shared.structs.add_unset(innermost);
  std::vector<hir::Expr*> sizes;
  for (const ast::Expr* size : expr.sizes) {
    sizes.push_back(checker.check_as(*size, {.type = checker.types.integer(), .name = "size"}));
    type = checker.types.list(type);
  }
  return checker.make<hir::NewArrayExpr>(hir::ExprKind::kNewArray, type, expr.span,
                                         checker.seq(sizes));
}

hir::Expr* check_until(Checker& checker, const ast::UntilExpr& until) {
  hir::Expr* motion = checker.check(*until.motion);
  const bool is_motion = motion->kind == hir::ExprKind::kCallNative &&
                         motion->as<hir::CallNativeExpr>().function->pauses;
  if (!is_motion && !motion->type->is(Kind::kAny)) {
    // An expression that is not a call was reported by the parser.
    if (until.motion->kind == ast::ExprKind::kCall)
      checker.report(make_diagnostic("E0315", motion->span,
                                     {"a motion before `until`", type_phrase(motion->type)}));
    return checker.failed(until.span);
  }
  hir::Expr* guard = check_guard(checker, *until.condition);
  return checker.make<hir::GuardedExpr>(hir::ExprKind::kGuarded, motion->type, until.span, motion,
                                        guard);
}

}  // namespace

}  // namespace armlet::lang
