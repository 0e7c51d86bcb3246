#include "check/names/reading.hpp"

#include "check/names/variables.hpp"
#include "check/state/learnt.hpp"
#include "hir/analysis.hpp"

namespace armlet::lang {

std::string dotted_name(Checker& checker, const ast::Expr& expr) {
  if (expr.kind == ast::ExprKind::kName) {
    const std::string_view name = expr.as<ast::NameExpr>().name;
    FunctionContext* where = nullptr;
    return checker.scopes.find(name, where) == nullptr ? std::string(name) : std::string();
  }
  if (expr.kind != ast::ExprKind::kMember) return {};
  const auto& member = expr.as<ast::MemberExpr>();
  const std::string object = dotted_name(checker, *member.object);
  return object.empty() ? object : object + '.' + std::string(member.member.text);
}

std::string_view kind_of(const hir::Expr& value) {
  if (const Fact* fact = fact_of(value)) return fact->kind();
  if (value.kind != hir::ExprKind::kVariable) return {};
  const hir::Variable* variable = value.as<hir::VariableExpr>().variable;
  while (variable->kind.empty() && variable->outer != nullptr) variable = variable->outer;
  return variable->kind;
}

void note_call(Checker& checker, const hir::Function* function) {
  checker.scopes.use().add(function);
  if (checker.scopes.in_program())
    checker.shared.uses.add_main_call(function, checker.shared.top_level.count());
}

void note_type_use(Checker& checker, const Type& type, Span name) {
  if (checker.shared.learnt == nullptr) return;
  Checker* const home = checker.shared.structs.home(&type);
  if (home != nullptr)
    checker.shared.learnt->use(name, home->names.declaration_of(type_name(&type)));
}

const Flow& flow_for(const Checker& checker, const FunctionContext& where) {
  const FunctionContext* context = &checker.scopes.here();
  while (context != &where && context->kind != FunctionContext::Kind::kTask &&
         context->outer != nullptr) {
    context = context->outer;
  }
  return context->kind == FunctionContext::Kind::kTask ? context->flow : where.flow;
}

void note_assigned(FunctionContext& here, const hir::Variable* variable) {
  here.flow.assign(variable);
  const FunctionContext* context = &here;
  while (context->kind == FunctionContext::Kind::kTask) {
    if (variable->owner != context->function || variable->outer == nullptr) return;
    variable = variable->outer;
    here.flow.assign(variable);
    context = context->outer;
  }
}

hir::Variable* captured(Checker& checker, Local& local, FunctionContext& owner,
                        FunctionContext& here) {
  if (&here == &owner) return local.variable;
  const bool of_program = owner.kind == FunctionContext::Kind::kProgram;
  if (of_program) checker.scopes.use().add(local.variable);
  const bool is_function =
      here.kind == FunctionContext::Kind::kNamed || here.kind == FunctionContext::Kind::kTest;
  if (is_function || here.outer == nullptr) {
    checker.shared.top_level.make_global(*local.variable);
    return local.variable;
  }
  hir::Variable* outer = captured(checker, local, owner, *here.outer);
  const bool shares = here.kind == FunctionContext::Kind::kCondition ||
                      here.kind == FunctionContext::Kind::kTask || here.in_row;
  if (shares && (outer->storage == hir::Storage::kGlobal || here.outer == &checker.scopes.main())) {
    checker.shared.top_level.make_global(*outer);
    return outer;
  }
  if (const auto known = here.inner_of.find(outer); known != here.inner_of.end())
    return known->second;
  hir::Variable* inner = new_variable(checker, outer->name, outer->type, outer->declared);
  inner->owner = here.function;
  inner->outer = outer;
  inner->fixed = true;
  inner->init = outer->init;
  if (shares && !outer->fixed) {
    // A variable that never changes can be copied.
    inner->fixed = false;
    inner->storage = outer->storage = hir::Storage::kBoxed;
  }
  here.captures.push_back({outer, inner});
  here.inner_of.emplace(outer, inner);
  return inner;
}

hir::Expr* read(Checker& checker, Local& local, FunctionContext& where, Span span) {
  local.used = true;
  hir::Variable* variable = local.variable;
  if (checker.shared.learnt != nullptr) checker.shared.learnt->use(span, variable->declared);
  const bool of_program = where.kind == FunctionContext::Kind::kProgram;
  if (of_program &&
      &checker.scopes.use() != &checker.shared.uses.of(checker.scopes.main().function))
    checker.scopes.use().add(variable);
  const bool in_sequence =
      &where == &checker.scopes.here() || !of_program || checker.scopes.in_program();
  if (in_sequence && flow_for(checker, where).is_unset(variable)) {
    Diagnostic diagnostic = make_diagnostic("E0211", span, {std::string(variable->name)});
    diagnostic.related.push_back({variable->declared, "declared without a value"});
    checker.report(std::move(diagnostic));
    return checker.failed(span);
  }
  if (&where != &checker.scopes.here())
    variable = captured(checker, local, where, checker.scopes.here());
  return checker.make<hir::VariableExpr>(hir::ExprKind::kVariable, variable->type, span, variable);
}

}  // namespace armlet::lang
