#include "check/check.hpp"

#include <algorithm>

#include "check/blocks/number_dims.hpp"
#include "check/declarations/declarations.hpp"
#include "check/entries/keep.hpp"
#include "check/entries/shown.hpp"
#include "check/explain/file_names.hpp"
#include "check/functions/functions.hpp"
#include "check/names/imports.hpp"
#include "check/names/variables.hpp"
#include "check/state/checker.hpp"
#include "check/state/learnt.hpp"
#include "check/statements/statements.hpp"
#include "check/statements/usage.hpp"

namespace armlet::lang {

namespace {

void check_top_level(Checker& checker) {
  std::vector<hir::Stmt*> body;
  checker.scopes.open_block();
  const ast::Seq<ast::Stmt*> written = checker.file.program.body;
  // A recording contains all statements after it.
  const bool shows = checker.into.entry.is_one && is_main_file(checker) && !written.empty() &&
                     std::ranges::none_of(written, [](const ast::Stmt* stmt) {
                       return stmt->kind == ast::StmtKind::kRecord;
                     });
  checker.check_into(shows ? written.first(written.size() - 1) : written, body);
  if (shows && checker.scopes.here().flow.reachable) {
    checker.messages.begin_statement();
    if (hir::Stmt* last = check_last(checker, *written.back())) append(*written.back(), last, body);
  } else if (shows) {
    checker.check_into(written.last(1), body);
  }
  checker.scopes.main().function->body =
      checker.make<hir::Block>(hir::StmtKind::kBlock, checker.file.program.span, checker.seq(body));
}

// Checks that need the whole program.
void finish(Shared& shared, CheckedProgram& into) {
  Checker& main = *shared.files.back();
  hir::Module& module = into.module;
  module.main = main.scopes.main().function;
  module.functions = into.arena->copy(shared.instances.functions());
  module.tests = into.arena->copy(main.postponed.tests());
  module.globals = into.arena->copy(shared.top_level.number_globals());
  module.global_count = static_cast<std::uint32_t>(module.globals.size());
  module.unset = into.arena->copy(shared.structs.unset());
  into.names.functions.assign(shared.mentions.all().begin(), shared.mentions.all().end());
  into.names.declared = shared.blocks.all();
}

// Checks the bodies that were postponed, and those of functions that are never called.
void check_functions(Checker& checker) {
  const auto work_off = [&checker] {
    while (Instance* instance = checker.shared.instances.next()) {
      check_body(*instance->declaration->file, *instance);
    }
  };
  checker.shared.instances.turn_round();
  work_off();
  for (auto& [name, function] : checker.names.functions()) {
    if (!function.instances.empty()) continue;
    if (function.is_generic() && !checker.shared.guesses) {
      if (checker.shared.learnt != nullptr) checker.shared.learnt->leave_out();
      continue;
    }
    checker.messages.begin_statement();
    // A parameter without a declared type is known only when the function is called.
    std::vector<const Type*> types = function.parameters;
    std::replace(types.begin(), types.end(), static_cast<const Type*>(nullptr),
                 checker.types.any());
    instance_of(checker, function, std::move(types), function.node->name.span);
    work_off();
  }
}

// Reports statements in a text that may only contain declarations.
void check_only_declares(Checker& checker, const CompileOptions& options, DiagnosticSink& sink) {
  if (options.only_blocks.empty()) return;
  for (const ast::Stmt* stmt : checker.file.program.body) {
    bool declares = stmt->kind == ast::StmtKind::kEmpty ||
                    (stmt->kind == ast::StmtKind::kVar && stmt->as<ast::VarStmt>().fixed);
    if (stmt->kind == ast::StmtKind::kObject) {
      const ast::TypeExpr& type = *stmt->as<ast::ObjectStmt>().type;
      declares =
          type.form == ast::TypeForm::kNamed && type.path.size() == 1 &&
          std::ranges::find(options.only_blocks, type.path[0].text) != options.only_blocks.end();
    }
    sink.begin_statement();
    if (!declares) sink.report(options.refuse(stmt->span));
  }
}

}  // namespace

bool check_program(std::span<const FileTree> files, CheckedProgram& into, const Registry& registry,
                   const CompileOptions& options, DiagnosticSink& sink, Learnt* learnt) {
  const KeptNames* const before = into.entry.before;
  if (before == nullptr) {
    into.library_types = registry.library_types();
    into.types = std::make_shared<TypePool>(into.library_types.get());
  }
  into.messages = &registry.messages();
  into.language = &registry.language();
  Shared shared(into, registry, before, sink);
  shared.learnt = learnt;
  shared.guesses = learnt != nullptr && learnt->guesses();
  if (into.entry.is_one) shared.top_level.keep_all();
  std::deque<Checker> checkers;
  for (const FileTree& file : files)
    shared.files.push_back(&checkers.emplace_back(file, shared, into, registry, options, sink));
  Checker& main = checkers.back();
  if (before != nullptr) {
    main.follow(before->main());
    shared.blocks.follow(before->blocks);
  }
  const auto make_program = [&shared](Checker& file, std::string_view name) {
    hir::Function* const function = shared.instances.make_function(name, file.file.program.span);
    file.scopes.begin(function, shared.uses.of(function));
  };
  make_program(main, "");  // the first of all functions
  for (Checker& file : checkers) {
    if (&file != &main) make_program(file, file_name(file));
    bind_imports(file);
    collect(file, file.file.program);
  }
  check_only_declares(main, options, sink);
  for (Checker& file : checkers) check_top_level(file);
  check_waiting_tests(main);  // tests of imported files are run on their own
  for (Checker& file : checkers) check_functions(file);
  for (Checker& file : checkers) close_block(file);
  for (Checker& file : checkers) refuse_active_statements(file);
  if (!sink.has_errors()) finish_usage(main);
  if (!sink.has_errors()) finish_units(main);
  if (options.open || into.entry.is_one) shared.top_level.open(into.sources->first());
  run_imports_first(main);
  finish(shared, into);
  if (into.entry.is_one && !sink.has_errors()) keep_names(main);
  into.entry.before = nullptr;
  return !sink.has_errors();
}

}  // namespace armlet::lang
