#include "check/names/variables.hpp"

#include <string>
#include <utility>
#include <vector>

#include "check/state/learnt.hpp"

namespace armlet::lang {
namespace {

void advise_hidden(Checker& checker, const ast::Name& name) {
  std::string_view what;
  if (checker.names.find_function(name.text) != nullptr) {
    what = "function of this file";
  } else if (checker.names.find_variable(name.text) != nullptr) {
    what = "top-level variable";
  } else if (!checker.registry.functions(name.text).empty()) {
    what = "library function";
  }
  if (what.empty()) return;
  Diagnostic advice =
      make_diagnostic("W0708", name.span, {std::string(name.text), std::string(what)});
  checker.report(std::move(advice));
}

}  // namespace

hir::Variable* new_variable(Checker& checker, std::string_view name, const Type* type, Span span) {
  auto* variable = checker.arena.make<hir::Variable>();
  variable->name = checker.arena.copy(name);
  variable->type = type;
  variable->declared = span;
  variable->owner = checker.scopes.here().function;
  if (checker.shared.learnt != nullptr && !name.empty()) checker.shared.learnt->variable(*variable);
  return variable;
}

hir::Variable* hidden(Checker& checker, const Type* type, Span span) {
  hir::Variable* variable = new_variable(checker, {}, type, span);
  variable->fixed = true;
  return variable;
}

void close_block(Checker& checker) {
  const std::size_t begin = checker.scopes.close_block();
  const bool in_function = checker.scopes.here().root().kind != FunctionContext::Kind::kProgram;
  for (std::size_t i = begin; i < checker.scopes.here().locals.size(); ++i) {
    const Local& local = checker.scopes.here().locals[i];
    checker.scopes.here().flow.assign(local.variable);
    const bool declared = local.how == Declared::kLet || local.how == Declared::kFinal ||
                          local.how == Declared::kVar || local.how == Declared::kClassic;
    const Type* type = local.variable->type;
    // After an error some uses of the variable may not have been checked.
    if (local.used || checker.messages.errors() > 0 || !declared || !in_function ||
        type->is(Kind::kAny) || type->is(Kind::kHost) || local.variable->name.starts_with('_')) {
      continue;
    }
    checker.report(
        make_diagnostic("W0709", local.variable->declared, {std::string(local.variable->name)}));
  }
  checker.scopes.forget(begin);
}

bool is_free(Checker& checker, const ast::Name& name, const ast::Expr* value, Span keyword) {
  Span first{};
  std::vector<Edit> changed;  // that change the first declaration to a variable
  bool found = false;
  for (FunctionContext* context = &checker.scopes.here(); context != nullptr && !found;
       context = context->outer) {
    if (const Local* local = context->find(name.text)) {
      first = local->variable->declared;
      if (local->how == Declared::kLet) changed.push_back({local->keyword, "var"});
      found = true;
    }
  }
  if (!found && checker.scopes.in_program()) {
    if (const FunctionDecl* function = checker.names.own_function(name.text)) {
      first = function->node->name.span;
      found = true;
    }
  }
  if (const Import* import = found ? nullptr : checker.names.own_import(name.text)) {
    first = import->span;
    found = checker.scopes.in_program();
  }
  if (!found) {
    if (checker.scopes.here().root().kind == FunctionContext::Kind::kNamed)
      advise_hidden(checker, name);
    return true;
  }
  Diagnostic diagnostic = make_diagnostic("E0204", name.span, {std::string(name.text)});
  diagnostic.mark.label = "declared again";
  diagnostic.related.push_back({first, "first declared here"});
  diagnostic.fix = Fix{.text = "choose another name"};
  if (value != nullptr && checker.names.own_function(name.text) == nullptr &&
      checker.names.own_import(name.text) == nullptr) {
    diagnostic.fix->text += ", or write " + std::string(name.text) + " = " +
                            checker.text_of(value->span) +
                            " if you want to change it (then declare it with var)";
    if (!keyword.empty()) {
      changed.push_back({{keyword.begin, name.span.begin, keyword.source}, ""});
      diagnostic.fix->edits = std::move(changed);
    }
  }
  checker.report(std::move(diagnostic));
  return false;
}

}  // namespace armlet::lang
