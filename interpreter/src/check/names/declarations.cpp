// Declarations: variables, structs, enums, functions, tests.

#include <algorithm>
#include <unordered_set>

#include "check/checker.hpp"
#include "check/explain/divided_remarks.hpp"
#include "check/names/imports.hpp"
#include "check/names/look_ahead.hpp"
#include "check/types/any_table.hpp"

namespace armlet::lang {

hir::Variable* Checker::new_variable(std::string_view name, const Type* type, Span span) {
  auto* variable = arena_.make<hir::Variable>();
  variable->name = arena_.copy(name);
  variable->type = type;
  variable->declared = span;
  variable->owner = here_->function;
  return variable;
}

hir::Variable* Checker::hidden(const Type* type, Span span) {
  hir::Variable* variable = new_variable({}, type, span);
  variable->fixed = true;
  return variable;
}

Local* Checker::add_local(hir::Variable* variable, Declared how, Span keyword) {
  here_->add({.variable = variable, .how = how, .keyword = keyword});
  return &here_->locals.back();
}

void Checker::close_block() {
  const std::size_t begin = here_->blocks.back();
  here_->blocks.pop_back();
  const bool in_function = here_->root().kind != FunctionContext::Kind::kProgram;
  for (std::size_t i = begin; i < here_->locals.size(); ++i) {
    const Local& local = here_->locals[i];
    here_->flow.assign(local.variable);
    const bool declared = local.how == Declared::kLet || local.how == Declared::kFinal ||
                          local.how == Declared::kVar || local.how == Declared::kClassic;
    const Type* type = local.variable->type;
    // After an error a use may not have been seen.
    if (local.used || errors_ > 0 || !declared || !in_function || type->is(Kind::kAny) ||
        type->is(Kind::kHost) || local.variable->name.starts_with('_')) {
      continue;
    }
    report(make_diagnostic("W0709", local.variable->declared, {std::string(local.variable->name)}));
  }
  // The top level stays visible to functions that are checked later.
  if (here_ != &main_ || !here_->blocks.empty()) here_->drop(begin);
}

// Whether a name can be declared here; says so if not.
bool Checker::is_free(const ast::Name& name, const ast::Expr* value, Span keyword) {
  Span first{};
  std::vector<Edit> changed;  // that make the first declaration a variable
  bool found = false;
  for (FunctionContext* context = here_; context != nullptr && !found; context = context->outer) {
    if (const Local* local = context->find(name.text)) {
      first = local->variable->declared;
      if (local->how == Declared::kLet) changed.push_back({local->keyword, "var"});
      found = true;
    }
  }
  if (!found && &here_->root() == &main_) {
    if (const FunctionDecl* function = find_function(name.text)) {
      first = function->node->name.span;
      found = true;
    }
  }
  if (const Import* import = found ? nullptr : find_import(*this, name.text)) {
    first = import->span;
    found = &here_->root() == &main_;
  }
  if (!found) {
    if (here_->root().kind == FunctionContext::Kind::kNamed) advise_hidden(name);
    return true;
  }
  Diagnostic diagnostic = make_diagnostic("E0204", name.span, {std::string(name.text)});
  diagnostic.mark.label = "declared again";
  diagnostic.related.push_back({first, "first declared here"});
  diagnostic.fix = Fix{.text = "choose another name"};
  if (value != nullptr && find_function(name.text) == nullptr &&
      find_import(*this, name.text) == nullptr) {
    diagnostic.fix->text += ", or write " + std::string(name.text) + " = " + text_of(value->span) +
                            " if you want to change it (then declare it with var)";
    if (!keyword.empty()) {
      changed.push_back({{keyword.begin, name.span.begin, keyword.source}, ""});
      diagnostic.fix->edits = std::move(changed);
    }
  }
  report(std::move(diagnostic));
  return false;
}

void Checker::advise_hidden(const ast::Name& name) {
  std::string_view what;
  if (find_function(name.text) != nullptr) {
    what = "function of this file";
  } else if (top_level_names_.contains(name.text)) {
    what = "top-level variable";
  } else if (!registry_.functions(name.text).empty()) {
    what = "library function";
  }
  if (what.empty()) return;
  Diagnostic advice =
      make_diagnostic("W0708", name.span, {std::string(name.text), std::string(what)});
  report(std::move(advice));
}

// ---- variables ---------------------------------------------------------------------------------

hir::Stmt* Checker::check_var(const ast::VarStmt& stmt) {
  std::vector<hir::Stmt*> body;
  for (const ast::Declarator& declarator : stmt.declarators) {
    if (hir::Stmt* init = declare(stmt, declarator)) body.push_back(init);
  }
  if (body.size() == 1) return body[0];
  if (body.empty()) return nullptr;
  return make<hir::Block>(hir::StmtKind::kBlock, stmt.span, seq(body));
}

namespace {

// let xs = [] and let m = [:]: whether the type of the elements is not known, after a message.
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

}  // namespace

hir::Stmt* Checker::declare(const ast::VarStmt& stmt, const ast::Declarator& declarator) {
  const ast::Name& name = declarator.name;
  const bool top_level = here_ == &main_ && main_.blocks.size() == 1;
  const Type* type = declarator.type != nullptr ? resolve(*declarator.type) : nullptr;
  Use used;
  Use* const use_before = use_;
  if (top_level) use_ = &used;
  const bool classic_before = std::exchange(classic_declaration_, stmt.classic);
  if (declarator.init != nullptr) naming_ = {name.text, declarator.init->span};
  hir::Expr* value = declarator.init != nullptr ? check_value(*declarator.init, type) : nullptr;
  classic_declaration_ = classic_before;
  if (value != nullptr) advise_on_divided_remark(*this, *declarator.init, *value, type);
  if (value != nullptr && type != nullptr)
    value = require(value, {.type = type, .name = name.text});
  use_ = use_before;
  if (type == nullptr && value != nullptr) {
    type = value->type;
    if (refuse_unknown_elements(*this, name, *value)) type = types_.any();
  }
  if (type == nullptr) {
    report(make_diagnostic("E0323", name.span, {"`" + std::string(name.text) + "`"}));
    type = types_.any();
  }
  if (type->is(Kind::kVoid)) {
    report(make_diagnostic("E0315", declarator.type->span, {"a type with values", "void"}));
    type = types_.any();
  }
  const bool alone = stmt.declarators.size() == 1;
  const bool fresh = is_free(name, declarator.init, alone ? stmt.keyword : Span{});
  hir::Variable* variable = new_variable(name.text, type, name.span);
  variable->fixed = stmt.fixed;
  const Declared how = !stmt.fixed    ? (stmt.classic ? Declared::kClassic : Declared::kVar)
                       : stmt.classic ? Declared::kFinal
                                      : Declared::kLet;
  // Fixed in fact, when nothing in the text changes it.
  if (value != nullptr && (stmt.fixed || !changed_names_.contains(name.text))) {
    variable->init = value;
    note_constant(*variable);
  }
  if (fresh) add_local(variable, how, stmt.keyword);
  if (fresh && value == nullptr) here_->flow.unset.insert(variable);
  auto* init = make<hir::InitStmt>(
      hir::StmtKind::kInit,
      cover(stmt.keyword, declarator.init != nullptr ? declarator.init->span : name.span), variable,
      value);
  if (top_level) {
    top_level_.emplace_back(variable, init);
    init_uses_[variable] = std::move(used);
  }
  return init;
}

// ---- what is visible in the whole file ---------------------------------------------------------

void Checker::collect(const ast::Block& program) {
  look_ahead(program);
  collect_types(program);
  collect_functions(program);
}

void Checker::collect_types(const ast::Block& program) {
  const auto add = [&](const ast::Name& name, const Type* type) {
    if (named_types_.emplace(name.text, type).second) {
      type_names_[name.text] = name.span;
      shared_.homes[type] = this;
      return true;
    }
    sink_.begin_statement();
    report(make_diagnostic("E0204", name.span, {std::string(name.text)}));
    return false;
  };
  for (const ast::Stmt* stmt : program.body) {
    if (stmt->kind == ast::StmtKind::kStruct) {
      const auto& node = stmt->as<ast::StructStmt>();
      const Type* type = types_.new_record(std::string(node.name.text));
      if (add(node.name, type)) structs_[type->record] = {&node, this, type};
    } else if (stmt->kind == ast::StmtKind::kEnum) {
      const auto& node = stmt->as<ast::EnumStmt>();
      std::vector<std::string> values;
      std::unordered_set<std::string_view> known;
      for (const ast::Name& value : node.values) {
        if (!known.insert(value.text).second) {
          sink_.begin_statement();
          report(make_diagnostic("E0204", value.span, {std::string(value.text)}));
          continue;
        }
        values.emplace_back(value.text);
      }
      add(node.name, types_.new_enum(std::string(node.name.text), std::move(values)));
    }
  }
  for (const ast::Stmt* stmt : program.body) {
    if (stmt->kind == ast::StmtKind::kStruct) fill_struct(stmt->as<ast::StructStmt>());
  }
  refuse_endless();
}

void Checker::fill_struct(const ast::StructStmt& node) {
  const auto found = named_types_.find(node.name.text);
  if (found == named_types_.end() || !found->second->is(Kind::kRecord)) return;
  RecordInfo& record = *found->second->record;
  if (structs_[&record].node != &node) return;
  std::unordered_set<std::string_view> known;
  for (const ast::Param& field : node.fields) {
    sink_.begin_statement();
    const Type* type = field.type != nullptr ? resolve(*field.type) : types_.any();
    if (field.type == nullptr)
      report(make_diagnostic("E0323", field.name.span, {"`" + std::string(field.name.text) + "`"}));
    if (!known.insert(field.name.text).second) {
      report(make_diagnostic("E0204", field.name.span, {std::string(field.name.text)}));
    }
    record.fields.push_back({std::string(field.name.text), type, field.default_value != nullptr});
  }
}

void Checker::collect_functions(const ast::Block& program) {
  for (const ast::Stmt* stmt : program.body) {
    if (stmt->kind != ast::StmtKind::kFunction) continue;
    const auto& node = stmt->as<ast::FunctionStmt>();
    sink_.begin_statement();
    const FunctionDecl* first = find_function(node.name.text);
    const Import* import = find_import(*this, node.name.text);
    if (first != nullptr || import != nullptr) {
      Diagnostic diagnostic =
          make_diagnostic("E0204", node.name.span, {std::string(node.name.text)});
      diagnostic.mark.label = "declared again";
      diagnostic.related.push_back(
          {first != nullptr ? first->node->name.span : import->span, "first declared here"});
      diagnostic.fix = Fix{.text = "choose another name"};
      report(std::move(diagnostic));
      continue;
    }
    FunctionDecl& function = functions_[node.name.text];
    function.node = &node;
    function.file = this;
    std::unordered_map<std::string_view, Span> known;
    for (std::size_t i = 0; i < node.params.size(); ++i) {
      const ast::Param& param = node.params[i];
      function.parameters.push_back(resolve_open(*this, param.type));
      const auto [earlier, is_new] = known.try_emplace(param.name.text, param.name.span);
      if (is_new) continue;
      Diagnostic diagnostic =
          make_diagnostic("E0204", param.name.span, {std::string(param.name.text)});
      diagnostic.mark.label = "declared again";
      diagnostic.related.push_back({earlier->second, "first declared here"});
      report(std::move(diagnostic));
    }
    if (node.result != nullptr) {
      function.result = resolve_open(*this, node.result);
    } else if (node.body != nullptr && !returns_a_value(*node.body)) {
      function.result = types_.void_type();
    }
  }
}

hir::Stmt* Checker::check_test(const ast::TestStmt& stmt) {
  if (here_ != &main_ || main_.blocks.size() > 1) return nullptr;  // refused before
  // Checked when the whole top level is known.
  waiting_tests_.push_back(&stmt);
  return nullptr;
}

void Checker::check_waiting_tests() {
  for (const ast::TestStmt* stmt : waiting_tests_) {
    FunctionContext context;
    context.kind = FunctionContext::Kind::kTest;
    context.function = new_function("test " + text_of(stmt->name_span), stmt->span);
    context.result = types_.void_type();
    context.result_is_declared = true;
    FunctionContext* const before = std::exchange(here_, &context);
    Use* const use_before = std::exchange(use_, &use_of(context.function));
    context.function->body = check_block(stmt->body->body, stmt->body->span);
    here_ = before;
    use_ = use_before;
    tests_.push_back({arena_.copy(stmt->name), context.function, stmt->span});
  }
}

}  // namespace armlet::lang
