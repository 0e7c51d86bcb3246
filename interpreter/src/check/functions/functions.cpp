#include "check/functions/functions.hpp"

#include <algorithm>

#include "check/explain/divided_remarks.hpp"
#include "check/explain/edits.hpp"
#include "check/names/reading.hpp"
#include "check/names/variables.hpp"
#include "check/state/checker.hpp"
#include "check/state/learnt.hpp"
#include "check/types/any_table.hpp"
#include "check/types/mismatch.hpp"
#include "check/types/types.hpp"

namespace armlet::lang {
namespace {

// The limit of types for which a function is checked. A function that calls itself with new types
// each time would never end.
constexpr std::size_t kMostInstances = 200;

}  // namespace

Instance* instance_of(Checker& checker, FunctionDecl& function, std::vector<const Type*> types,
                      Span call) {
  const std::string name(function.node->name.text);
  const auto found =
      std::ranges::find(function.instances, types, [](const Instance* i) { return i->types; });
  if (found != function.instances.end()) {
    if (!(*found)->result_known) checker.report(make_diagnostic("E0324", call, {name}));
    return (*found)->result_known ? *found : nullptr;
  }
  if (function.failed && function.is_generic() && !checker.shared.guesses) return nullptr;
  if (function.instances.size() >= kMostInstances) {
    checker.report(make_diagnostic("E0125", call, {std::to_string(kMostInstances) + " levels"}));
    return nullptr;
  }
  Instance& instance = checker.shared.instances.add(function, std::move(types), call);
  if (function.result != nullptr) {
    instance.function->result = function.result;
    instance.result_known = true;
    checker.shared.instances.wait(instance);
    return &instance;
  }
  check_body(checker, instance);
  if (!instance.result_known || instance.function->result->is(Kind::kAny)) return nullptr;
  return &instance;
}

void check_body(Checker& checker, Instance& instance) {
  if (std::exchange(instance.checked, true)) return;
  FunctionDecl& declaration = *instance.declaration;
  const ast::FunctionStmt& node = *declaration.node;
  FunctionContext context;
  context.kind = FunctionContext::Kind::kNamed;
  context.function = instance.function;
  context.declaration = &declaration;
  context.instance = &instance;
  context.result = declaration.result;
  context.result_is_declared = declaration.result != nullptr;

  const Scopes::Position outside =
      checker.scopes.enter(context, checker.shared.uses.of(instance.function));
  const bool failed_before = checker.messages.statement_failed();
  const bool classic_before = checker.surroundings.set_classic(false);
  const bool top_before = checker.scopes.see_top_level_only(false);
  const int errors_before = checker.messages.errors();
  const Depth::Level level(checker.shared.depth);
  checker.messages.begin_statement();
  checker.scopes.open_block();
  std::vector<hir::Variable*> parameters;
  for (std::size_t i = 0; i < node.params.size(); ++i) {
    hir::Variable* variable = new_variable(checker, node.params[i].name.text, instance.types[i],
                                           node.params[i].name.span);
    variable->is_parameter = variable->fixed = true;
    parameters.push_back(variable);
    checker.scopes.add(variable, Declared::kParameter, node.params[i].span);
  }
  instance.function->parameters = checker.seq(parameters);
  if (node.body != nullptr) {
    instance.function->body = checker.check_block(node.body->body, node.body->span);
  } else {
    instance.function->body = value_body(checker, *node.value, context);
  }
  const Span end = node.body != nullptr
                       ? Span{node.body->span.end - 1, node.body->span.end, node.body->span.source}
                       : node.value->span;
  finish_result(checker, context, instance.function->name, end);
  if (checker.shared.learnt != nullptr)
    checker.shared.learnt->result(node.name.span, context.result);
  close_block(checker);
  checker.scopes.come_back(outside);
  checker.messages.set_statement_failed(failed_before);
  checker.surroundings.set_classic(classic_before);
  checker.scopes.see_top_level_only(top_before);
  if (checker.messages.errors() > errors_before) declaration.failed = true;
  instance.result_known = true;
}

hir::Stmt* return_value(Checker& checker, hir::Expr* value, Span span) {
  FunctionContext& context = checker.scopes.here();
  if (context.result_is_declared) {
    value = checker.require(value, {.role = Target::Role::kResult, .type = context.result});
  } else if (value->type->is(Kind::kVoid)) {
    value = mismatch(checker, *value, {.type = checker.types.any()});
  }
  if (!context.result_is_declared) {
    hir::Expr seen{.kind = hir::ExprKind::kVariable, .type = context.result, .span = span};
    const Type* common =
        context.result == nullptr ? value->type : common_type(checker, seen, *value);
    if (common == nullptr) {
      mismatch(checker, *value, {.role = Target::Role::kResult, .type = context.result});
      common = checker.types.any();
    }
    context.result = common;
  }
  auto* stmt = checker.make<hir::ReturnStmt>(hir::StmtKind::kReturn, span, value);
  context.returns.push_back(stmt);
  context.flow.reachable = false;
  return stmt;
}

// The body of a function `=> value`: it returns the value, or runs the expression if that has none.
hir::Block* value_body(Checker& checker, const ast::Expr& expr, FunctionContext& context) {
  hir::Expr* value = checker.check(expr, context.result);
  hir::Stmt* stmt = nullptr;
  const bool wants_nothing = context.result_is_declared && context.result->is(Kind::kVoid);
  if (value->type->is(Kind::kVoid) && (!context.result_is_declared || wants_nothing)) {
    stmt = checker.make<hir::ExprStmt>(hir::StmtKind::kExpr, expr.span, value);
    context.result = checker.types.void_type();
  } else if (wants_nothing && context.kind == FunctionContext::Kind::kLambda) {
    stmt = checker.make<hir::ExprStmt>(hir::StmtKind::kExpr, expr.span, value);
  } else {
    advise_on_divided_remark(checker, expr, *value,
                             context.result_is_declared ? context.result : nullptr);
    stmt = return_value(checker, value, expr.span);
  }
  return checker.make<hir::Block>(hir::StmtKind::kBlock, expr.span,
                                  checker.seq(std::vector<hir::Stmt*>{stmt}));
}

// Completes an inferred result, and checks that every path through the function returns a value.
void finish_result(Checker& checker, FunctionContext& context, std::string_view name, Span end) {
  if (!context.result_is_declared) {
    if (context.result == nullptr) context.result = checker.types.void_type();
    for (hir::ReturnStmt* stmt : context.returns) {
      if (stmt->value == nullptr) continue;
      if (hir::Expr* value = checker.convert(stmt->value, context.result)) stmt->value = value;
    }
    context.function->result = context.result;
    const ast::FunctionStmt* written =
        context.declaration != nullptr ? context.declaration->node : nullptr;
    if (written != nullptr && is_any_table(checker, written->result) &&
        !fits_any_table(written->result, context.result)) {
      checker.messages.begin_statement();
      checker.report(
          make_diagnostic("E0315", written->result->span,
                          {any_table_phrase(written->result), type_phrase(context.result)}));
    }
  }
  const Type* result = context.result;
  if (result->is(Kind::kVoid) || result->is(Kind::kAny) || !context.flow.reachable) return;
  checker.messages.begin_statement();
  Diagnostic diagnostic = make_diagnostic("E0306", end, {std::string(name)});
  diagnostic.mark.label = "the end can be reached without a return";
  // The mark begins at the function's name, so that its line is shown too.
  const Span head{context.function->span.begin, context.function->span.begin,
                  context.function->span.source};
  diagnostic.related.push_back({head, ""});
  diagnostic.fix = Fix{.text = "return " + type_phrase(result) + " here, or throw an error"};
  if (checker.text_of(end) == "}") {
    const std::string statement = "throw error(\"" + std::string(name) + " has no value here\")";
    diagnostic.fix->edits.push_back(at_end_of_block(checker, end, statement));
  }
  checker.report(std::move(diagnostic));
}

// The name of a function in the position of a value.
hir::Expr* function_value(Checker& checker, FunctionDecl& function, const Type* expected,
                          Span span) {
  if (checker.shared.learnt != nullptr) checker.shared.learnt->use(span, function.node->name.span);
  std::vector<const Type*> types = function.parameters;
  if (expected != nullptr && expected->is(Kind::kFunction) &&
      expected->parameters.size() == types.size()) {
    for (std::size_t i = 0; i < types.size(); ++i) {
      if (types[i] == nullptr) types[i] = expected->parameters[i];
    }
  }
  if (std::ranges::find(types, nullptr) != types.end()) {
    checker.report(
        make_diagnostic("E0323", span, {"`" + std::string(function.node->name.text) + "`"}));
    return checker.failed(span);
  }
  Instance* instance = instance_of(*function.file, function, types, span);
  if (instance == nullptr) return checker.failed(span);
  note_call(checker, instance->function);
  const Type* type = checker.types.function(std::move(types), instance->function->result);
  return checker.make<hir::FunctionValueExpr>(hir::ExprKind::kFunctionValue, type, span,
                                              instance->function);
}

bool settle(Checker& checker, const hir::Expr& table) {
  for (std::size_t i = 0;
       table.type->is_open_table() && i < checker.shared.instances.waiting().size(); ++i) {
    Instance& waiting = *checker.shared.instances.waiting()[i];
    check_body(*waiting.declaration->file, waiting);
  }
  if (!table.type->is_open_table()) return true;
  // The assignment of the table may have failed.
  if (checker.messages.has_errors()) return false;
  Diagnostic diagnostic = make_diagnostic("E0323", table.span, {"the columns of this table"});
  diagnostic.message = "the columns of this table are not known here";
  diagnostic.why = "nothing above this line puts a table there";
  checker.report(std::move(diagnostic));
  return false;
}

}  // namespace armlet::lang
