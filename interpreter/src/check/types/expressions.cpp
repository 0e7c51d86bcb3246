// Names, literals, lists, `? :` and what else is no operator and no call.

#include <algorithm>

#include "check/checker.hpp"
#include "check/explain/joined_lines.hpp"
#include "check/names/function_names.hpp"
#include "check/names/imports.hpp"
#include "check/statements/tasks.hpp"
#include "check/types/maps.hpp"
#include "check/types/matrices.hpp"
#include "check/types/new_structs.hpp"
#include "compile/cancelled.hpp"

namespace armlet::lang {
namespace {

// Checks nest as the text does, and as bodies of called functions do. The parser limits the first;
// this bounds both.
constexpr int kDeepest = 600;

}  // namespace

hir::Expr* Checker::check(const ast::Expr& expr, const Type* expected) {
  stop_if(options_.cancelled);
  if (depth_ >= kDeepest) {
    report(make_diagnostic("E0125", expr.span, {std::to_string(kDeepest) + " levels"}));
    return failed(expr.span);
  }
  const Joined joined = joined_line(*this, expr);
  if (!joined.bracket.empty()) joined_.push_back(joined);
  ++depth_;
  hir::Expr* out = check_any(expr, expected);
  --depth_;
  if (!joined.bracket.empty()) joined_.pop_back();
  return out;
}

hir::Expr* Checker::check_value(const ast::Expr& expr, const Type* expected) {
  hir::Expr* value = check(expr, expected);
  if (!value->type->is(Kind::kVoid)) return value;
  return mismatch(*value, {.type = types_.any()});
}

hir::Expr* Checker::check_any(const ast::Expr& expr, const Type* expected) {
  using ast::ExprKind;
  switch (expr.kind) {
    case ExprKind::kInt:
    case ExprKind::kReal:
    case ExprKind::kQuantity:
    case ExprKind::kText:
    case ExprKind::kBool:
      return check_literal(expr);
    case ExprKind::kFormatted:
      return check_formatted(expr.as<ast::FormattedExpr>());
    case ExprKind::kName:
      return check_name(expr.as<ast::NameExpr>(), expected);
    case ExprKind::kMember:
      return check_member(expr.as<ast::MemberExpr>(), expected);
    case ExprKind::kIndex:
      return check_index(expr.as<ast::IndexExpr>());
    case ExprKind::kCall:
      return check_call(expr.as<ast::CallExpr>(), expected);
    case ExprKind::kUnary:
      return check_unary(expr.as<ast::UnaryExpr>(), expected);
    case ExprKind::kBinary:
      return check_binary(expr.as<ast::BinaryExpr>(), expected);
    case ExprKind::kCond:
      return check_conditional(expr.as<ast::CondExpr>(), expected);
    case ExprKind::kCast: {
      const auto& node = expr.as<ast::CastExpr>();
      return cast(check_value(*node.operand), type_called(node.type.text), expr.span);
    }
    case ExprKind::kList:
      return check_list(expr, expr.as<ast::ListExpr>().items, expected);
    case ExprKind::kBrace:
      return check_list(expr, expr.as<ast::BraceExpr>().items, expected);
    case ExprKind::kMap:
      return check_map(*this, expr.as<ast::MapExpr>(), expected);
    case ExprKind::kMatrix:
      return check_matrix(*this, expr.as<ast::MatrixExpr>());
    case ExprKind::kNewObject:
      return check_new_object(expr.as<ast::NewObjectExpr>());
    case ExprKind::kNewArray:
      return check_new_array(expr.as<ast::NewArrayExpr>());
    case ExprKind::kLambda:
      return check_lambda(expr.as<ast::LambdaExpr>(), expected);
    case ExprKind::kUntil:
      return check_until(expr.as<ast::UntilExpr>());
  }
  return failed(expr.span);
}

hir::Expr* Checker::check_literal(const ast::Expr& expr) {
  using ast::ExprKind;
  switch (expr.kind) {
    case ExprKind::kInt: {
      const auto& node = expr.as<ast::IntExpr>();
      if (node.too_large) {
        report(make_diagnostic("E0109", expr.span, {text_of(expr.span)}));
        return failed(expr.span);
      }
      return make<hir::IntExpr>(hir::ExprKind::kInt, types_.integer(), expr.span, node.value);
    }
    case ExprKind::kReal:
      return make<hir::RealExpr>(hir::ExprKind::kReal, types_.real(), expr.span,
                                 expr.as<ast::RealExpr>().value);
    case ExprKind::kQuantity: {
      const auto& node = expr.as<ast::QuantityExpr>();
      return make<hir::RealExpr>(hir::ExprKind::kReal, types_.quantity(node.dim), expr.span,
                                 node.si);
    }
    case ExprKind::kText: {
      const std::string_view text = arena_.copy(expr.as<ast::TextExpr>().value);
      return make<hir::TextExpr>(hir::ExprKind::kText, types_.text(), expr.span, text);
    }
    case ExprKind::kBool:
      return make<hir::BoolExpr>(hir::ExprKind::kBool, types_.boolean(), expr.span,
                                 expr.as<ast::BoolExpr>().value);
    default:
      return failed(expr.span);
  }
}

// ---- names -------------------------------------------------------------------------------------

Local* Checker::find_local(std::string_view name, FunctionContext*& where) {
  if (!only_top_level_) {
    for (where = here_; where != nullptr; where = where->outer) {
      if (Local* local = where->find(name)) return local;
    }
    if (&here_->root() == &main_) return nullptr;
  }
  // Named functions and tests see what the top level has declared so far, but not its inner blocks.
  where = &main_;
  Local* local = main_.find(name);
  const bool inner =
      local != nullptr && main_.blocks.size() > 1 && local >= main_.locals.data() + main_.blocks[1];
  return inner ? nullptr : local;
}

FunctionDecl* Checker::find_function(std::string_view name) {
  const auto found = functions_.find(name);
  return found == functions_.end() ? nullptr : &found->second;
}

hir::Expr* Checker::check_name(const ast::NameExpr& name, const Type* expected) {
  FunctionContext* where = nullptr;
  if (Local* local = find_local(name.name, where)) return read(*local, *where, name.span);
  if (FunctionDecl* function = find_function(name.name))
    return function_value(*function, expected, name.span);
  if (const NativeConstant* constant = registry_.constant(name.name)) {
    mentioned_.insert(std::string(name.name));
    return make<hir::RealExpr>(hir::ExprKind::kReal, types_.quantity(constant->dim), name.span,
                               constant->value);
  }
  if (hir::Expr* value = library_function_value(*this, name, name.name, expected)) return value;
  const bool is_group = registry_.is_namespace(name.name) || name.name == "Math";
  const char* what = find_import(*this, name.name) != nullptr  ? "module"
                     : is_group                                ? "group of functions"
                     : type_called(name.name) != nullptr       ? "type"
                     : !registry_.functions(name.name).empty() ? "function of the library"
                                                               : nullptr;
  if (what == nullptr) return unknown_name(name.name, name.span, expected);
  if (syntax_failed_ || !told_.emplace(name.name).second) return failed(name.span);
  Diagnostic diagnostic = make_diagnostic("E0219", name.span, {std::string(name.name), what});
  const auto works_alone = [&](const NativeFunction* function) {
    const auto& parameters = signature_of(*function).parameters;
    return std::ranges::all_of(parameters, [&](const Parameter& parameter) {
      const bool ambient = &parameter == parameters.data() && parameter.type.type != nullptr &&
                           parameter.type.type->is(Kind::kHost) &&
                           parameter.type.type->host->is_ambient;
      return ambient || parameter.may_be_left_out();
    });
  };
  if (std::ranges::any_of(registry_.functions(name.name), works_alone)) {
    const Span behind{name.span.end, name.span.end, name.span.source};
    diagnostic.fix =
        Fix{.text = "write " + std::string(name.name) + "()", .edits = {{behind, "()"}}};
  } else if (const std::string lambda = lambda_around(*this, name.name);
             !lambda.empty() && !(naming_.value == name.span)) {
    diagnostic.fix = Fix{.text = "write " + lambda, .edits = {{name.span, lambda}}};
  }
  report(std::move(diagnostic));
  return failed(name.span);
}

hir::Expr* Checker::read(Local& local, FunctionContext& where, Span span) {
  local.used = true;
  hir::Variable* variable = local.variable;
  const bool of_program = where.kind == FunctionContext::Kind::kProgram;
  if (of_program && use_ != &uses_[main_.function]) use_->add(variable);
  const bool in_sequence = &where == here_ || !of_program || &here_->root() == &main_;
  if (in_sequence && flow_for(*this, where).is_unset(variable)) {
    Diagnostic diagnostic = make_diagnostic("E0211", span, {std::string(variable->name)});
    diagnostic.related.push_back({variable->declared, "declared without a value"});
    report(std::move(diagnostic));
    return failed(span);
  }
  if (&where != here_) variable = captured(local, where, *here_);
  return make<hir::VariableExpr>(hir::ExprKind::kVariable, variable->type, span, variable);
}

// ---- values made of values ---------------------------------------------------------------------

hir::Expr* Checker::check_conditional(const ast::CondExpr& cond, const Type* expected) {
  hir::Expr* condition_value = condition(*cond.condition);
  hir::Expr* yes = check_value(*cond.yes, expected);
  hir::Expr* no = check_value(*cond.no, expected);
  const Type* type = common_type(*yes, *no);
  hir::Expr* left = type != nullptr ? convert(yes, type) : nullptr;
  hir::Expr* right = type != nullptr ? convert(no, type) : nullptr;
  if (left == nullptr || right == nullptr) {
    Diagnostic diagnostic =
        make_diagnostic("E0311", no->span, {type_phrase(yes->type), type_phrase(no->type)});
    diagnostic.mark.label = type_name(no->type);
    diagnostic.related.push_back({yes->span, type_name(yes->type)});
    report(std::move(diagnostic));
    return failed(cond.span);
  }
  return make<hir::CondExpr>(hir::ExprKind::kCond, type, cond.span, condition_value, left, right);
}

hir::Expr* Checker::check_list(const ast::Expr& expr, ast::Seq<ast::Expr*> items,
                               const Type* expected) {
  if (items.empty() && expr.kind == ast::ExprKind::kBrace && expected != nullptr &&
      expected->is(Kind::kMap))
    return empty_map(*this, expected, expr.span);
  const Type* wanted =
      expected != nullptr && expected->is(Kind::kList) ? expected->element : nullptr;
  std::vector<hir::Expr*> values;
  const Type* element = nullptr;
  hir::Expr* widest = nullptr;
  for (const ast::Expr* item : items) {
    values.push_back(check_value(*item, wanted));
    if (values.back()->type->is(Kind::kAny)) return failed(expr.span);
    if (wanted != nullptr) continue;
    element = widest == nullptr ? values[0]->type : common_type(*widest, *values.back());
    if (element == nullptr) {
      report(make_diagnostic("E0330", values.back()->span,
                             {type_phrase(widest->type), type_phrase(values.back()->type)}));
      return failed(expr.span);
    }
    if (widest == nullptr || element != widest->type) widest = values.back();
  }
  if (wanted != nullptr) {
    // The whole list keeps its own types when the target wants others, so that the message is about
    // the target.
    for (hir::Expr*& value : values) {
      value = require(value, {.role = Target::Role::kElement, .type = wanted});
      if (value->type->is(Kind::kAny)) return failed(expr.span);
    }
    element = wanted;
  } else {
    for (hir::Expr*& value : values) {
      if (hir::Expr* same = convert(value, element)) value = same;
    }
  }
  if (element == nullptr) element = types_.any();
  return make<hir::ListExpr>(hir::ExprKind::kList, types_.list(element), expr.span, seq(values));
}

hir::Expr* Checker::check_new_array(const ast::NewArrayExpr& expr) {
  const Type* type = resolve(*expr.element);
  if (type->is(Kind::kAny)) return failed(expr.span);
  const Type* innermost = type;
  for (int i = 0; i < expr.open_dimensions; ++i) type = types_.list(type);
  if (expr.init != nullptr)
    return check_list(*expr.init, expr.init->as<ast::BraceExpr>().items, type);
  if (expr.open_dimensions == 0) {
    if (hir::Expr* list = new_structs(*this, expr, innermost)) return list;
  }
  if (expr.open_dimensions == 0 && !has_zero(*innermost)) shared_.unset.insert(innermost);
  std::vector<hir::Expr*> sizes;
  for (const ast::Expr* size : expr.sizes) {
    sizes.push_back(check_as(*size, {.type = types_.integer(), .name = "size"}));
    type = types_.list(type);
  }
  return make<hir::NewArrayExpr>(hir::ExprKind::kNewArray, type, expr.span, seq(sizes));
}

hir::Expr* Checker::check_until(const ast::UntilExpr& until) {
  hir::Expr* motion = check(*until.motion);
  const bool is_motion = motion->kind == hir::ExprKind::kCallNative &&
                         motion->as<hir::CallNativeExpr>().function->pauses;
  if (!is_motion && !motion->type->is(Kind::kAny)) {
    // What is no call at all has been told of when it was read.
    if (until.motion->kind == ast::ExprKind::kCall)
      report(make_diagnostic("E0315", motion->span,
                             {"a motion before `until`", type_phrase(motion->type)}));
    return failed(until.span);
  }
  hir::Expr* guard = check_guard(*until.condition);
  return make<hir::GuardedExpr>(hir::ExprKind::kGuarded, motion->type, until.span, motion, guard);
}

}  // namespace armlet::lang
