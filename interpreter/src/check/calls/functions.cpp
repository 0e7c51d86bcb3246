// Functions of the text: one typed form for every combination of argument types, results found from
// bodies.

#include <algorithm>

#include "check/checker.hpp"
#include "check/explain/divided_remarks.hpp"
#include "check/explain/edits.hpp"
#include "check/types/any_table.hpp"

namespace armlet::lang {
namespace {

// A function that calls itself with ever new types would never end.
constexpr std::size_t kMostInstances = 200;

}  // namespace

hir::Function* Checker::new_function(std::string_view name, Span span) {
  auto* function = arena_.make<hir::Function>();
  function->name = arena_.copy(name);
  function->span = span;
  function->index = static_cast<std::uint32_t>(all_functions_.size());
  function->result = types_.void_type();
  all_functions_.push_back(function);
  return function;
}

Instance* Checker::instance_of(FunctionDecl& function, std::vector<const Type*> types, Span call) {
  const std::string name(function.node->name.text);
  const auto found =
      std::ranges::find(function.instances, types, [](const Instance* i) { return i->types; });
  if (found != function.instances.end()) {
    if (!(*found)->result_known) report(make_diagnostic("E0324", call, {name}));
    return (*found)->result_known ? *found : nullptr;
  }
  if (function.failed && function.is_generic()) return nullptr;
  if (function.instances.size() >= kMostInstances) {
    report(make_diagnostic("E0125", call, {std::to_string(kMostInstances) + " levels"}));
    return nullptr;
  }
  Instance& instance = instances_.emplace_back();
  instance.types = std::move(types);
  instance.declaration = &function;
  instance.first_call = call;
  instance.function = new_function(name, function.node->span);
  function.instances.push_back(&instance);
  if (function.result != nullptr) {
    instance.function->result = function.result;
    instance.result_known = true;
    queue_.push_back(&instance);
    return &instance;
  }
  check_body(instance);
  if (!instance.result_known || instance.function->result->is(Kind::kAny)) return nullptr;
  return &instance;
}

void Checker::check_body(Instance& instance) {
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

  FunctionContext* const before = std::exchange(here_, &context);
  Use* const use_before = std::exchange(use_, &use_of(instance.function));
  const bool failed_before = sink_.statement_failed();
  const bool classic_before = std::exchange(classic_declaration_, false);
  const bool top_before = std::exchange(only_top_level_, false);
  const int errors_before = errors_;
  ++depth_;
  sink_.begin_statement();
  open_block();
  std::vector<hir::Variable*> parameters;
  for (std::size_t i = 0; i < node.params.size(); ++i) {
    hir::Variable* variable =
        new_variable(node.params[i].name.text, instance.types[i], node.params[i].name.span);
    variable->is_parameter = variable->fixed = true;
    parameters.push_back(variable);
    add_local(variable, Declared::kParameter, node.params[i].span);
  }
  instance.function->parameters = seq(parameters);
  if (node.body != nullptr) {
    instance.function->body = check_block(node.body->body, node.body->span);
  } else {
    instance.function->body = value_body(*node.value, context);
  }
  const Span end = node.body != nullptr
                       ? Span{node.body->span.end - 1, node.body->span.end, node.body->span.source}
                       : node.value->span;
  finish_result(context, instance.function->name, end);
  close_block();
  --depth_;
  here_ = before;
  use_ = use_before;
  sink_.set_statement_failed(failed_before);
  classic_declaration_ = classic_before;
  only_top_level_ = top_before;
  if (errors_ > errors_before) declaration.failed = true;
  instance.result_known = true;
}

// => value: returns it, or runs it if it gives nothing.
hir::Block* Checker::value_body(const ast::Expr& expr, FunctionContext& context) {
  hir::Expr* value = check(expr, context.result);
  hir::Stmt* stmt = nullptr;
  const bool wants_nothing = context.result_is_declared && context.result->is(Kind::kVoid);
  if (value->type->is(Kind::kVoid) && (!context.result_is_declared || wants_nothing)) {
    stmt = make<hir::ExprStmt>(hir::StmtKind::kExpr, expr.span, value);
    context.result = types_.void_type();
  } else if (wants_nothing && context.kind == FunctionContext::Kind::kLambda) {
    stmt = make<hir::ExprStmt>(hir::StmtKind::kExpr, expr.span, value);
  } else {
    advise_on_divided_remark(*this, expr, *value,
                             context.result_is_declared ? context.result : nullptr);
    stmt = return_value(value, expr.span);
  }
  return make<hir::Block>(hir::StmtKind::kBlock, expr.span, seq(std::vector<hir::Stmt*>{stmt}));
}

// Settles an inferred result, and sees that every way through returns one.
void Checker::finish_result(FunctionContext& context, std::string_view name, Span end) {
  if (!context.result_is_declared) {
    if (context.result == nullptr) context.result = types_.void_type();
    for (hir::ReturnStmt* stmt : context.returns) {
      if (stmt->value == nullptr) continue;
      if (hir::Expr* value = convert(stmt->value, context.result)) stmt->value = value;
    }
    context.function->result = context.result;
    const ast::FunctionStmt* written =
        context.declaration != nullptr ? context.declaration->node : nullptr;
    if (written != nullptr && is_any_table(*this, written->result) &&
        !fits_any_table(written->result, context.result)) {
      sink_.begin_statement();
      report(make_diagnostic("E0315", written->result->span,
                             {any_table_phrase(written->result), type_phrase(context.result)}));
    }
  }
  const Type* result = context.result;
  if (result->is(Kind::kVoid) || result->is(Kind::kAny) || !context.flow.reachable) return;
  sink_.begin_statement();
  Diagnostic diagnostic = make_diagnostic("E0306", end, {std::string(name)});
  diagnostic.mark.label = "the end can be reached without a return";
  // The line of the function's name is shown too.
  const Span head{context.function->span.begin, context.function->span.begin,
                  context.function->span.source};
  diagnostic.related.push_back({head, ""});
  diagnostic.fix = Fix{.text = "return " + type_phrase(result) + " here, or throw an error"};
  if (text_of(end) == "}") {
    const std::string statement = "throw error(\"" + std::string(name) + " has no value here\")";
    diagnostic.fix->edits.push_back(at_end_of_block(*this, end, statement));
  }
  report(std::move(diagnostic));
}

// The name of a function where a value is needed.
hir::Expr* Checker::function_value(FunctionDecl& function, const Type* expected, Span span) {
  std::vector<const Type*> types = function.parameters;
  if (expected != nullptr && expected->is(Kind::kFunction) &&
      expected->parameters.size() == types.size()) {
    for (std::size_t i = 0; i < types.size(); ++i) {
      if (types[i] == nullptr) types[i] = expected->parameters[i];
    }
  }
  if (std::ranges::find(types, nullptr) != types.end()) {
    report(make_diagnostic("E0323", span, {"`" + std::string(function.node->name.text) + "`"}));
    return failed(span);
  }
  Instance* instance = function.file->instance_of(function, types, span);
  if (instance == nullptr) return failed(span);
  use_->add(instance->function);
  if (&here_->root() == &main_) main_calls_.emplace_back(instance->function, top_level_.size());
  const Type* type = types_.function(std::move(types), instance->function->result);
  return make<hir::FunctionValueExpr>(hir::ExprKind::kFunctionValue, type, span,
                                      instance->function);
}

}  // namespace armlet::lang
