#include "check/declarations/declarations.hpp"

#include <algorithm>
#include <set>
#include <unordered_set>
#include <utility>

#include "check/declarations/endless.hpp"
#include "check/declarations/look_ahead.hpp"
#include "check/explain/divided_remarks.hpp"
#include "check/names/reading.hpp"
#include "check/names/variables.hpp"
#include "check/state/checker.hpp"
#include "check/state/learnt.hpp"
#include "check/types/any_table.hpp"

namespace armlet::lang {

namespace {

void collect_types(Checker& checker, const ast::Block& program);
void fill_struct(Checker& checker, const ast::StructStmt& node);
void collect_functions(Checker& checker, const ast::Block& program);

}  // namespace

namespace {}  // namespace

// ---- variables ---------------------------------------------------------------------------------

namespace {

hir::Stmt* declare(Checker& checker, const ast::VarStmt& stmt, const ast::Declarator& declarator);

}  // namespace

hir::Stmt* check_var(Checker& checker, const ast::VarStmt& stmt) {
  std::vector<hir::Stmt*> body;
  for (const ast::Declarator& declarator : stmt.declarators) {
    if (hir::Stmt* init = declare(checker, stmt, declarator)) body.push_back(init);
  }
  if (body.size() == 1) return body[0];
  if (body.empty()) return nullptr;
  return checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.span, checker.seq(body));
}

namespace {

// let xs = [] and let m = [:]: reports a message if the type of the elements is not known.
bool refuse_unknown_elements(Checker& checker, const ast::Name& name, const hir::Expr& value) {
  const Type* inner = value.type;
  while (inner->is(Kind::kList) || inner->is(Kind::kMap)) inner = inner->element;
  if (inner == value.type || !inner->is(Kind::kAny)) return false;
  const bool is_map = value.type->is(Kind::kMap);
  Diagnostic diagnostic =
      make_diagnostic("E0323", value.span, {is_map ? "this empty map" : "this empty list"});
  const Span after{name.span.end, name.span.end, name.span.source};
  const std::string written = is_map ? ": int[string]" : ": double[]";
  diagnostic.fix = Fix{.text = "write its type, such as " + std::string(name.text) + written,
                       .edits = {{after, written}}};
  checker.report(std::move(diagnostic));
  return true;
}

hir::Stmt* declare(Checker& checker, const ast::VarStmt& stmt, const ast::Declarator& declarator) {
  const ast::Name& name = declarator.name;
  const bool top_level = checker.scopes.at_top_level();
  const Type* type = declarator.type != nullptr ? checker.resolve(*declarator.type) : nullptr;
  Use used;
  Use& use_before = checker.scopes.use();
  if (top_level) checker.scopes.collect_in(used);
  const bool classic_before = checker.surroundings.set_classic(stmt.classic);
  if (declarator.init != nullptr) checker.surroundings.set_named(name.text, declarator.init->span);
  hir::Expr* value =
      declarator.init != nullptr ? checker.check_value(*declarator.init, type) : nullptr;
  checker.surroundings.set_classic(classic_before);
  if (value != nullptr) advise_on_divided_remark(checker, *declarator.init, *value, type);
  if (value != nullptr && type != nullptr)
    value = checker.require(value, {.type = type, .name = name.text});
  checker.scopes.collect_in(use_before);
  if (type == nullptr && value != nullptr) {
    type = value->type;
    if (refuse_unknown_elements(checker, name, *value)) type = checker.types.any();
  }
  if (type == nullptr) {
    checker.report(make_diagnostic("E0323", name.span, {"`" + std::string(name.text) + "`"}));
    type = checker.types.any();
  }
  if (type->is(Kind::kVoid)) {
    checker.report(make_diagnostic("E0315", declarator.type->span, {"a type with values", "void"}));
    type = checker.types.any();
  }
  const bool alone = stmt.declarators.size() == 1;
  const bool fresh = is_free(checker, name, declarator.init, alone ? stmt.keyword : Span{});
  hir::Variable* variable = new_variable(checker, name.text, type, name.span);
  variable->fixed = stmt.fixed;
  const Declared how = !stmt.fixed    ? (stmt.classic ? Declared::kClassic : Declared::kVar)
                       : stmt.classic ? Declared::kFinal
                                      : Declared::kLet;
  if (value != nullptr && type->is(Kind::kHost)) variable->kind = kind_of(*value);
  // A variable that the text never changes counts as constant.
  if (value != nullptr && (stmt.fixed || !checker.names.is_changed(name.text))) {
    variable->init = value;
    checker.shared.constants.note(*variable);
    if (checker.shared.learnt != nullptr)
      checker.shared.learnt->constant(name.span, checker.shared.constants.of(*value));
  }
  if (fresh) checker.scopes.add(variable, how, stmt.keyword);
  if (fresh && value == nullptr) checker.scopes.here().flow.unset.insert(variable);
  auto* init = checker.make<hir::InitStmt>(
      hir::StmtKind::kInit,
      cover(stmt.keyword, declarator.init != nullptr ? declarator.init->span : name.span), variable,
      value);
  if (top_level) {
    checker.shared.top_level.add(variable, init, std::move(used));
  }
  return init;
}

}  // namespace

// ---- what is visible in the whole file ---------------------------------------------------------

namespace {

// The ambient type of a declared variable: its declared type, or that of motors.something(...);
// null if it is not ambient.
const HostType* ambient_type(Checker& checker, const ast::TypeExpr* type, const ast::Expr* init) {
  while (type != nullptr && type->form == ast::TypeForm::kProduct && type->factors.size() == 1) {
    type = type->factors[0].type;
  }
  const HostType* host = nullptr;
  if (type != nullptr && type->form == ast::TypeForm::kNamed && type->path.size() == 1) {
    host = checker.registry.type(type->path[0].text);
  } else if (type == nullptr && init != nullptr && init->kind == ast::ExprKind::kCall) {
    const auto makers =
        checker.registry.functions(dotted_name(checker, *init->as<ast::CallExpr>().callee));
    const Type* result =
        makers.empty() ? nullptr : checker.shared.signatures.of(*makers[0]).result.type;
    if (result != nullptr && result->is(Kind::kHost)) host = result->host;
  }
  return host != nullptr && host->is_ambient ? host : nullptr;
}

// Collects facts about the whole text before any of it is checked.
void look_ahead(Checker& checker, const ast::Block& program) {
  const Sights sights = look_over(program);
  std::set<std::string_view> changed = sights.changed;
  // Later entries may change variables that this one does not change.
  for (const ast::Stmt* stmt : program.body) {
    if (!checker.into.entry.is_one || stmt->kind != ast::StmtKind::kVar) continue;
    const auto& declaration = stmt->as<ast::VarStmt>();
    for (const ast::Declarator& at : declaration.declarators)
      if (!declaration.fixed) changed.insert(at.name.text);
  }
  checker.names.set_changed(std::move(changed));
  for (const std::string_view name : sights.mentioned) {
    if (!checker.registry.functions(name).empty()) checker.shared.mentions.add(name);
  }
  for (const std::string_view name : sights.settings) {
    const std::string full = "with." + std::string(name);
    if (!checker.registry.functions(full).empty()) checker.shared.mentions.add(full);
  }
  const auto declare = [&](const ast::Name& name, const ast::TypeExpr* type,
                           const ast::Expr* init) {
    const bool is_new = checker.names.add_variable(name);
    if (const HostType* host = is_new ? ambient_type(checker, type, init) : nullptr)
      checker.names.add_ambient(host->name, name.text);
  };
  // The names of the rows of block declarations, with the type of their block.
  std::set<std::pair<std::string, std::string_view>> rows;
  for (const ast::Stmt* stmt : program.body) {
    if (stmt->kind == ast::StmtKind::kVar) {
      for (const ast::Declarator& at : stmt->as<ast::VarStmt>().declarators)
        declare(at.name, at.type, at.init);
    } else if (stmt->kind == ast::StmtKind::kObject) {
      const auto& node = stmt->as<ast::ObjectStmt>();
      declare(node.name, node.type, nullptr);
      const std::string block = checker.text_of(node.type->span);
      checker.shared.blocks.add(block, node.name.text);
      for (const ast::BlockItem& item : node.items) {
        if (!item.is_row && rows.insert({block, item.name.text}).second)
          checker.shared.blocks.add(block + '.' + std::string(item.name.text), node.name.text);
      }
    }
  }
}

}  // namespace

void collect(Checker& checker, const ast::Block& program) {
  look_ahead(checker, program);
  collect_types(checker, program);
  collect_functions(checker, program);
}

namespace {

void collect_types(Checker& checker, const ast::Block& program) {
  const auto add = [&](const ast::Name& name, const Type* type) {
    if (checker.names.add_type(name, type)) {
      checker.shared.structs.set_home(type, checker);
      return true;
    }
    checker.messages.begin_statement();
    checker.report(make_diagnostic("E0204", name.span, {std::string(name.text)}));
    return false;
  };
  for (const ast::Stmt* stmt : program.body) {
    if (stmt->kind == ast::StmtKind::kStruct) {
      const auto& node = stmt->as<ast::StructStmt>();
      const Type* type = checker.types.new_record(std::string(node.name.text));
      if (add(node.name, type)) checker.shared.structs.add({&node, &checker, type});
    } else if (stmt->kind == ast::StmtKind::kEnum) {
      const auto& node = stmt->as<ast::EnumStmt>();
      std::vector<std::string> values;
      std::unordered_set<std::string_view> known;
      for (const ast::Name& value : node.values) {
        if (!known.insert(value.text).second) {
          checker.messages.begin_statement();
          checker.report(make_diagnostic("E0204", value.span, {std::string(value.text)}));
          continue;
        }
        values.emplace_back(value.text);
      }
      const Type* type = checker.types.new_enum(std::string(node.name.text), std::move(values));
      if (checker.shared.learnt != nullptr)
        checker.shared.learnt->enumeration(*type->enumeration, node);
      add(node.name, type);
    }
  }
  for (const ast::Stmt* stmt : program.body) {
    if (stmt->kind == ast::StmtKind::kStruct) fill_struct(checker, stmt->as<ast::StructStmt>());
  }
  refuse_endless(checker);
}

void fill_struct(Checker& checker, const ast::StructStmt& node) {
  const Type* const found = checker.names.find_type(node.name.text);
  const StructDecl* const declared =
      found != nullptr ? checker.shared.structs.find(found) : nullptr;
  if (declared == nullptr || declared->node != &node) return;
  if (checker.shared.learnt != nullptr) checker.shared.learnt->structure(node, found);
  RecordInfo& record = *found->record;
  std::unordered_set<std::string_view> known;
  for (const ast::Param& field : node.fields) {
    checker.messages.begin_statement();
    const Type* type = field.type != nullptr ? checker.resolve(*field.type) : checker.types.any();
    if (field.type == nullptr)
      checker.report(
          make_diagnostic("E0323", field.name.span, {"`" + std::string(field.name.text) + "`"}));
    if (!known.insert(field.name.text).second) {
      checker.report(make_diagnostic("E0204", field.name.span, {std::string(field.name.text)}));
    }
    record.fields.push_back({std::string(field.name.text), type, field.default_value != nullptr});
  }
}

void collect_functions(Checker& checker, const ast::Block& program) {
  for (const ast::Stmt* stmt : program.body) {
    if (stmt->kind != ast::StmtKind::kFunction) continue;
    const auto& node = stmt->as<ast::FunctionStmt>();
    checker.messages.begin_statement();
    const FunctionDecl* first = checker.names.own_function(node.name.text);
    const Import* import = checker.names.own_import(node.name.text);
    if (first != nullptr || import != nullptr) {
      Diagnostic diagnostic =
          make_diagnostic("E0204", node.name.span, {std::string(node.name.text)});
      diagnostic.mark.label = "declared again";
      diagnostic.related.push_back(
          {first != nullptr ? first->node->name.span : import->span, "first declared here"});
      diagnostic.fix = Fix{.text = "choose another name"};
      checker.report(std::move(diagnostic));
      continue;
    }
    FunctionDecl& function = checker.names.add_function(node, checker);
    std::unordered_map<std::string_view, Span> known;
    for (std::size_t i = 0; i < node.params.size(); ++i) {
      const ast::Param& param = node.params[i];
      function.parameters.push_back(resolve_open(checker, param.type));
      const auto [earlier, is_new] = known.try_emplace(param.name.text, param.name.span);
      if (is_new) continue;
      Diagnostic diagnostic =
          make_diagnostic("E0204", param.name.span, {std::string(param.name.text)});
      diagnostic.mark.label = "declared again";
      diagnostic.related.push_back({earlier->second, "first declared here"});
      checker.report(std::move(diagnostic));
    }
    if (node.result != nullptr) {
      function.result = resolve_open(checker, node.result);
    } else if (node.body != nullptr && !returns_a_value(*node.body)) {
      function.result = checker.types.void_type();
    }
  }
}

}  // namespace

hir::Stmt* check_test(Checker& checker, const ast::TestStmt& stmt) {
  if (&checker.scopes.here() != &checker.scopes.main() || checker.scopes.main().blocks.size() > 1)
    return nullptr;  // refused before
  // Tests are checked after the whole top level.
  checker.postponed.add_test(stmt);
  return nullptr;
}

void check_waiting_tests(Checker& checker) {
  for (const ast::TestStmt* stmt : checker.postponed.waiting_tests()) {
    FunctionContext context;
    context.kind = FunctionContext::Kind::kTest;
    context.function = checker.shared.instances.make_function(
        "test " + checker.text_of(stmt->name_span), stmt->span);
    context.result = checker.types.void_type();
    context.result_is_declared = true;
    const Scopes::Position outside =
        checker.scopes.enter(context, checker.shared.uses.of(context.function));
    context.function->body = checker.check_block(stmt->body->body, stmt->body->span);
    checker.scopes.come_back(outside);
    checker.postponed.add_checked_test(
        {checker.arena.copy(stmt->name), context.function, stmt->span});
  }
}

}  // namespace armlet::lang
