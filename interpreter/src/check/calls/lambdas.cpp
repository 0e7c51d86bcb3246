// Functions inside functions: lambdas, which copy what they use, and conditions and tasks, which
// share it.

#include <algorithm>

#include "check/checker.hpp"
#include "check/names/imports.hpp"
#include "check/types/any_table.hpp"

namespace armlet::lang {

void Checker::make_global(hir::Variable& variable) {
  if (std::exchange(variable.storage, hir::Storage::kGlobal) == hir::Storage::kGlobal) return;
  if (!init_uses_.contains(&variable)) inner_globals_.push_back(&variable);  // not at top level
}

// The variable that `here` uses for a variable of `owner` outside of it.
hir::Variable* Checker::captured(Local& local, FunctionContext& owner, FunctionContext& here) {
  if (&here == &owner) return local.variable;
  const bool of_program = owner.kind == FunctionContext::Kind::kProgram;
  if (of_program && use_ != nullptr) use_->add(local.variable);
  const bool is_function =
      here.kind == FunctionContext::Kind::kNamed || here.kind == FunctionContext::Kind::kTest;
  if (is_function || here.outer == nullptr) {
    make_global(*local.variable);
    return local.variable;
  }
  hir::Variable* outer = captured(local, owner, *here.outer);
  const bool shares =
      here.kind == FunctionContext::Kind::kCondition || here.kind == FunctionContext::Kind::kTask;
  if (shares && (outer->storage == hir::Storage::kGlobal || here.outer == &main_)) {
    make_global(*outer);
    return outer;
  }
  if (const auto known = here.inner_of.find(outer); known != here.inner_of.end())
    return known->second;
  hir::Variable* inner = new_variable(outer->name, outer->type, outer->declared);
  inner->owner = here.function;
  inner->outer = outer;
  inner->fixed = true;
  inner->init = outer->init;
  if (shares && !outer->fixed) {
    // What never changes may as well be copied.
    inner->fixed = false;
    inner->storage = outer->storage = hir::Storage::kBoxed;
  }
  here.captures.push_back({outer, inner});
  here.inner_of.emplace(outer, inner);
  return inner;
}

hir::Expr* Checker::closure(hir::Function* function, FunctionContext& context, const Type* type,
                            Span span) {
  function->captures = seq(context.captures);
  use_->add(function);
  if (&here_->root() == &main_) main_calls_.emplace_back(function, top_level_.size());
  const auto kind =
      context.captures.empty() ? hir::ExprKind::kFunctionValue : hir::ExprKind::kClosure;
  if (context.captures.empty()) return make<hir::FunctionValueExpr>(kind, type, span, function);
  return make<hir::ClosureExpr>(kind, type, span, function);
}

// The parameters of a lambda, with the types that are written or expected; empty after a message.
std::optional<std::vector<hir::Variable*>> Checker::lambda_parameters(const ast::LambdaExpr& lambda,
                                                                      const Type* expected,
                                                                      hir::Function* owner) {
  std::vector<hir::Variable*> out;
  for (std::size_t i = 0; i < lambda.params.size(); ++i) {
    const ast::Param& param = lambda.params[i];
    const Type* given = expected != nullptr ? expected->parameters[i] : nullptr;
    const Type* type = param.type != nullptr ? resolve(*param.type) : given;
    if (given != nullptr && is_any_table(*this, param.type) && fits_any_table(param.type, given))
      type = given;
    if (type == nullptr) {
      const std::string name(param.name.text);
      Diagnostic diagnostic = make_diagnostic("E0323", param.name.span, {'`' + name + '`'});
      const std::string typed = name + ": " + likely_type_;
      diagnostic.fix = Fix{.text = "write its type, such as " + typed,
                           .edits = {{param.name.span, typed}},
                           .confidence = Confidence::kMaybe};
      report(std::move(diagnostic));
      return std::nullopt;
    }
    if (find_function(param.name.text) == nullptr && !is_free(param.name)) return std::nullopt;
    out.push_back(new_variable(param.name.text, type, param.name.span));
    out.back()->owner = owner;
    out.back()->is_parameter = out.back()->fixed = true;
  }
  return out;
}

hir::Expr* Checker::check_lambda(const ast::LambdaExpr& lambda, const Type* expected) {
  const bool fits = expected != nullptr && expected->is(Kind::kFunction) &&
                    expected->parameters.size() == lambda.params.size();
  FunctionContext context;
  context.kind = FunctionContext::Kind::kLambda;
  context.outer = here_;
  context.function = new_function("lambda on " + line_name(lambda.span), lambda.span);
  if (lambda.result != nullptr) {
    context.result = resolve(*lambda.result);
  } else if (fits && !expected->result->is(Kind::kAny)) {
    context.result = expected->result;
  }
  context.result_is_declared = context.result != nullptr;
  if (context.result_is_declared) context.function->result = context.result;
  const auto parameters = lambda_parameters(lambda, fits ? expected : nullptr, context.function);
  if (!parameters) return failed(lambda.span);
  context.function->parameters = seq(*parameters);

  FunctionContext* const before = std::exchange(here_, &context);
  Use* const use_before = std::exchange(use_, &use_of(context.function));
  open_block();
  std::vector<const Type*> types;
  for (hir::Variable* parameter : *parameters) {
    types.push_back(parameter->type);
    add_local(parameter, Declared::kParameter, parameter->declared);
  }
  if (lambda.body != nullptr) {
    const bool failed_before = sink_.statement_failed();
    context.function->body = check_block(lambda.body->body, lambda.body->span);
    if (failed_before) sink_.set_statement_failed(true);
  } else {
    context.function->body = value_body(*lambda.value, context);
  }
  finish_result(context, context.function->name,
                {lambda.span.end - 1, lambda.span.end, lambda.span.source});
  close_block();
  here_ = before;
  use_ = use_before;
  if (context.result->is(Kind::kAny)) return failed(lambda.span);
  return closure(context.function, context, types_.function(std::move(types), context.result),
                 lambda.span);
}

// The condition of until and wait until: a function without parameters that is called again and
// again.
hir::Expr* Checker::check_guard(const ast::Expr& written) {
  FunctionContext context;
  context.kind = FunctionContext::Kind::kCondition;
  context.outer = here_;
  context.function = new_function("condition on " + line_name(written.span), written.span);
  context.function->is_condition = true;
  context.function->result = types_.boolean();
  FunctionContext* const before = std::exchange(here_, &context);
  Use* const use_before = std::exchange(use_, &use_of(context.function));
  open_block();
  hir::Expr* value = condition(written);
  hir::Stmt* stmt = make<hir::ReturnStmt>(hir::StmtKind::kReturn, written.span, value);
  context.function->body =
      make<hir::Block>(hir::StmtKind::kBlock, written.span, seq(std::vector<hir::Stmt*>{stmt}));
  close_block();
  here_ = before;
  use_ = use_before;
  conditions_.emplace_back(context.function, written.span);
  return closure(context.function, context, types_.function({}, types_.boolean()), written.span);
}

}  // namespace armlet::lang
