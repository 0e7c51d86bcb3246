#include "check/check.hpp"

#include <algorithm>

#include "check/checker.hpp"
#include "check/look_ahead.hpp"

namespace armlet::lang {

// Notes what the whole text shows before any of it is checked.
void Checker::look_ahead(const ast::Block& program) {
  const Sights sights = look_over(program);
  changed_names_ = sights.changed;
  for (const std::string_view name : sights.mentioned) {
    if (!registry_.functions(name).empty()) mentioned_.insert(std::string(name));
  }
  const auto declare = [&](const ast::Name& name, const ast::TypeExpr* type,
                           const ast::Expr* init) {
    top_level_names_.emplace(name.text, name.span);
    if (const HostType* host = ambient_type(type, init))
      ambient_names_[host->name].push_back(name.text);
  };
  for (const ast::Stmt* stmt : program.body) {
    if (stmt->kind == ast::StmtKind::kVar) {
      for (const ast::Declarator& at : stmt->as<ast::VarStmt>().declarators)
        declare(at.name, at.type, at.init);
    } else if (stmt->kind == ast::StmtKind::kObject) {
      const auto& node = stmt->as<ast::ObjectStmt>();
      declare(node.name, node.type, nullptr);
      declared_names_[text_of(node.type->span)].emplace_back(node.name.text);
    }
  }
}

// The ambient type that a declaration shows: written, or made by robots.something(...); null if
// none.
const HostType* Checker::ambient_type(const ast::TypeExpr* type, const ast::Expr* init) {
  while (type != nullptr && type->form == ast::TypeForm::kProduct && type->factors.size() == 1) {
    type = type->factors[0].type;
  }
  const HostType* host = nullptr;
  if (type != nullptr && type->form == ast::TypeForm::kNamed && type->path.size() == 1) {
    host = registry_.type(type->path[0].text);
  } else if (type == nullptr && init != nullptr && init->kind == ast::ExprKind::kCall) {
    const auto makers = registry_.functions(dotted_name(*init->as<ast::CallExpr>().callee));
    const Type* result = makers.empty() ? nullptr : signature_of(*makers[0]).result.type;
    if (result != nullptr && result->is(Kind::kHost)) host = result->host;
  }
  return host != nullptr && host->is_ambient ? host : nullptr;
}

bool Checker::run() {
  registry_.declare_records(types_);
  error_type_ = types_.library_record("error");
  main_.function = new_function("", program_.span);
  use_ = &use_of(main_.function);
  collect(program_);

  std::vector<hir::Stmt*> body;
  open_block();
  check_into(program_.body, body);
  main_.function->body = make<hir::Block>(hir::StmtKind::kBlock, program_.span, seq(body));
  check_waiting_tests();
  check_functions();
  close_block();
  report_later();
  if (errors_ == 0) finish_usage();

  hir::Module& module = into_.module;
  std::vector<hir::Variable*> globals;
  for (const auto& [variable, init] : top_level_) {
    if (variable->storage == hir::Storage::kGlobal) globals.push_back(variable);
  }
  for (hir::Variable* variable : inner_globals_) globals.push_back(variable);
  for (std::size_t i = 0; i < globals.size(); ++i)
    globals[i]->index = static_cast<std::uint32_t>(i);
  module.main = main_.function;
  module.functions = seq(all_functions_);
  module.tests = seq(tests_);
  module.globals = seq(globals);
  module.global_count = static_cast<std::uint32_t>(globals.size());
  into_.mentioned.assign(mentioned_.begin(), mentioned_.end());
  return !sink_.has_errors();
}

// The bodies that could wait, and those of functions that nobody calls.
void Checker::check_functions() {
  const auto work_off = [this] {
    while (!queue_.empty()) {
      Instance* instance = queue_.back();
      queue_.pop_back();
      check_body(*instance);
    }
  };
  std::ranges::reverse(queue_);
  work_off();
  for (auto& [name, function] : functions_) {
    if (!function.instances.empty() || function.is_generic()) continue;
    sink_.begin_statement();
    instance_of(function, function.parameters, function.node->name.span);
    work_off();
  }
}

bool check_program(const ast::Block& program, CompiledProgram& into, const Registry& registry,
                   const CompileOptions& options, DiagnosticSink& sink) {
  if (into.arena == nullptr) into.arena = std::make_unique<Arena>();
  if (into.types == nullptr) into.types = std::make_unique<TypePool>();
  return Checker(program, into, registry, options, sink).run();
}

}  // namespace armlet::lang
