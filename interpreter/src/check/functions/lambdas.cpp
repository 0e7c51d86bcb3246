#include "check/functions/lambdas.hpp"

#include <algorithm>

#include "check/functions/functions.hpp"
#include "check/names/reading.hpp"
#include "check/names/variables.hpp"
#include "check/state/checker.hpp"
#include "check/types/any_table.hpp"

namespace armlet::lang {

hir::Expr* closure(Checker& checker, hir::Function* function, FunctionContext& context,
                   const Type* type, Span span) {
  function->captures = checker.seq(context.captures);
  note_call(checker, function);
  const auto kind =
      context.captures.empty() ? hir::ExprKind::kFunctionValue : hir::ExprKind::kClosure;
  if (context.captures.empty())
    return checker.make<hir::FunctionValueExpr>(kind, type, span, function);
  return checker.make<hir::ClosureExpr>(kind, type, span, function);
}

namespace {

// The parameters of a lambda, with their declared or expected types; empty after a message.
std::optional<std::vector<hir::Variable*>> lambda_parameters(Checker& checker,
                                                             const ast::LambdaExpr& lambda,
                                                             const Type* expected,
                                                             hir::Function* owner) {
  std::vector<hir::Variable*> out;
  for (std::size_t i = 0; i < lambda.params.size(); ++i) {
    const ast::Param& param = lambda.params[i];
    const Type* given = expected != nullptr ? expected->parameters[i] : nullptr;
    const Type* type = param.type != nullptr ? checker.resolve(*param.type) : given;
    if (given != nullptr && is_any_table(checker, param.type) && fits_any_table(param.type, given))
      type = given;
    if (type == nullptr) {
      const std::string name(param.name.text);
      Diagnostic diagnostic = make_diagnostic("E0323", param.name.span, {'`' + name + '`'});
      const std::string typed = name + ": " + checker.surroundings.likely_type();
      diagnostic.fix = Fix{.text = "write its type, such as " + typed,
                           .edits = {{param.name.span, typed}},
                           .confidence = Confidence::kMaybe};
      checker.report(std::move(diagnostic));
      return std::nullopt;
    }
    if (checker.names.find_function(param.name.text) == nullptr && !is_free(checker, param.name))
      return std::nullopt;
    out.push_back(new_variable(checker, param.name.text, type, param.name.span));
    out.back()->owner = owner;
    out.back()->is_parameter = out.back()->fixed = true;
  }
  return out;
}

}  // namespace

hir::Expr* check_lambda(Checker& checker, const ast::LambdaExpr& lambda, const Type* expected) {
  const bool fits = expected != nullptr && expected->is(Kind::kFunction) &&
                    expected->parameters.size() == lambda.params.size();
  FunctionContext context;
  context.kind = FunctionContext::Kind::kLambda;
  context.in_row = checker.surroundings.set_in_row(false);
  context.outer = &checker.scopes.here();
  context.function = checker.shared.instances.make_function(
      "lambda on " + line_name(checker, lambda.span), lambda.span);
  if (lambda.result != nullptr) {
    context.result = checker.resolve(*lambda.result);
  } else if (fits && !expected->result->is(Kind::kAny)) {
    context.result = expected->result;
  }
  context.result_is_declared = context.result != nullptr;
  if (context.result_is_declared) context.function->result = context.result;
  const auto parameters =
      lambda_parameters(checker, lambda, fits ? expected : nullptr, context.function);
  if (!parameters) {
    checker.surroundings.set_in_row(context.in_row);
    return checker.failed(lambda.span);
  }
  context.function->parameters = checker.seq(*parameters);

  const Scopes::Position outside =
      checker.scopes.enter(context, checker.shared.uses.of(context.function));
  checker.scopes.open_block();
  std::vector<const Type*> types;
  for (hir::Variable* parameter : *parameters) {
    types.push_back(parameter->type);
    checker.scopes.add(parameter, Declared::kParameter, parameter->declared);
  }
  if (lambda.body != nullptr) {
    const bool failed_before = checker.messages.statement_failed();
    context.function->body = checker.check_block(lambda.body->body, lambda.body->span);
    if (failed_before) checker.messages.set_statement_failed(true);
  } else {
    context.function->body = value_body(checker, *lambda.value, context);
  }
  finish_result(checker, context, context.function->name,
                {lambda.span.end - 1, lambda.span.end, lambda.span.source});
  checker.surroundings.set_in_row(context.in_row);
  close_block(checker);
  checker.scopes.come_back(outside);
  if (context.result->is(Kind::kAny)) return checker.failed(lambda.span);
  return closure(checker, context.function, context,
                 checker.types.function(std::move(types), context.result), lambda.span);
}

// The condition of until and wait until, as a function without parameters that is called at each
// instant.
hir::Expr* check_guard(Checker& checker, const ast::Expr& written) {
  FunctionContext context;
  context.kind = FunctionContext::Kind::kCondition;
  context.outer = &checker.scopes.here();
  context.function = checker.shared.instances.make_function(
      "condition on " + line_name(checker, written.span), written.span);
  context.function->is_condition = true;
  context.function->result = checker.types.boolean();
  const Scopes::Position outside =
      checker.scopes.enter(context, checker.shared.uses.of(context.function));
  checker.scopes.open_block();
  hir::Expr* value = checker.condition(written);
  hir::Stmt* stmt = checker.make<hir::ReturnStmt>(hir::StmtKind::kReturn, written.span, value);
  context.function->body = checker.make<hir::Block>(hir::StmtKind::kBlock, written.span,
                                                    checker.seq(std::vector<hir::Stmt*>{stmt}));
  close_block(checker);
  checker.scopes.come_back(outside);
  checker.shared.postponed.add(Postponed::Condition{context.function, written.span});
  return closure(checker, context.function, context,
                 checker.types.function({}, checker.types.boolean()), written.span);
}

}  // namespace armlet::lang
