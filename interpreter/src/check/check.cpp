#include "check/check.hpp"

#include <algorithm>

#include "check/checker.hpp"
#include "check/names/imports.hpp"
#include "check/names/look_ahead.hpp"

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
    const bool is_new = top_level_names_.emplace(name.text, name.span).second;
    if (const HostType* host = is_new ? ambient_type(type, init) : nullptr)
      ambient_names_[host->name].push_back(name.text);
  };
  for (const ast::Stmt* stmt : program.body) {
    if (stmt->kind == ast::StmtKind::kVar) {
      for (const ast::Declarator& at : stmt->as<ast::VarStmt>().declarators)
        declare(at.name, at.type, at.init);
    } else if (stmt->kind == ast::StmtKind::kObject) {
      const auto& node = stmt->as<ast::ObjectStmt>();
      declare(node.name, node.type, nullptr);
      DeclaredNames& names = declared_names_[text_of(node.type->span)];
      names.in_order.emplace_back(node.name.text);
      names.all.emplace(node.name.text);
    }
  }
}

// The ambient type that a declaration shows: written, or made by motors.something(...); null if
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

// What every part of the file may see from everywhere.
void Checker::begin() {
  use_ = &use_of(main_.function);
  bind_imports(*this);
  collect(program_);
}

void Checker::check_top_level() {
  std::vector<hir::Stmt*> body;
  open_block();
  check_into(program_.body, body);
  main_.function->body = make<hir::Block>(hir::StmtKind::kBlock, program_.span, seq(body));
}

namespace {

// What belongs to the program as a whole.
void finish(SharedState& shared, CompiledProgram& into) {
  std::vector<hir::Variable*> globals;
  for (const auto& [variable, init] : shared.top_level) {
    if (variable->storage == hir::Storage::kGlobal) globals.push_back(variable);
  }
  for (hir::Variable* variable : shared.inner_globals) globals.push_back(variable);
  for (std::size_t i = 0; i < globals.size(); ++i)
    globals[i]->index = static_cast<std::uint32_t>(i);
  hir::Module& module = into.module;
  module.main = shared.files.back()->main_.function;
  module.functions = into.arena->copy(shared.all_functions);
  module.tests = into.arena->copy(shared.tests);
  module.globals = into.arena->copy(globals);
  module.unset =
      into.arena->copy(std::vector<const Type*>(shared.unset.begin(), shared.unset.end()));
  module.global_count = static_cast<std::uint32_t>(globals.size());
  into.mentioned.assign(shared.mentioned.begin(), shared.mentioned.end());
  for (const auto& [type, names] : shared.declared_names)
    into.declared_names[type] = names.in_order;
}

}  // namespace

// The bodies that could wait, and those of functions that nobody calls.
void Checker::check_functions() {
  const auto work_off = [this] {
    while (!queue_.empty()) {
      Instance* instance = queue_.back();
      queue_.pop_back();
      instance->declaration->file->check_body(*instance);
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

bool check_program(std::span<const FileTree> files, CompiledProgram& into, const Registry& registry,
                   const CompileOptions& options, DiagnosticSink& sink) {
  if (into.arena == nullptr) into.arena = std::make_unique<Arena>();
  if (into.types == nullptr) into.types = std::make_unique<TypePool>();
  registry.declare_records(*into.types);
  into.messages = &registry.messages();
  SharedState shared;
  shared.error_type = into.types->library_record("error");
  std::deque<Checker> checkers;
  for (const FileTree& file : files)
    shared.files.push_back(&checkers.emplace_back(file, shared, into, registry, options, sink));
  Checker& main = checkers.back();
  main.main_.function = main.new_function("", main.program_.span);  // the first of all functions
  for (Checker& file : checkers) {
    if (&file != &main)
      file.main_.function = file.new_function(file_name(file), file.program_.span);
    file.begin();
  }
  for (Checker& file : checkers) file.check_top_level();
  main.check_waiting_tests();  // those of imported files are run by themselves
  for (Checker& file : checkers) file.check_functions();
  for (Checker& file : checkers) file.close_block();
  for (Checker& file : checkers) refuse_active_statements(file);
  main.report_later();
  if (!sink.has_errors()) main.finish_usage();
  run_imports_first(main);
  finish(shared, into);
  return !sink.has_errors();
}

}  // namespace armlet::lang
