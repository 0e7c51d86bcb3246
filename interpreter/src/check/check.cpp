#include "check/check.hpp"

#include <algorithm>

#include "check/calls/functions.hpp"
#include "check/checker.hpp"
#include "check/names/declarations.hpp"
#include "check/names/imports.hpp"
#include "check/names/look_ahead.hpp"
#include "check/scopes/usage.hpp"

namespace armlet::lang {

namespace {

void check_top_level(Checker& checker) {
  std::vector<hir::Stmt*> body;
  checker.scopes.open_block();
  checker.check_into(checker.file.program.body, body);
  checker.scopes.main().function->body =
      checker.make<hir::Block>(hir::StmtKind::kBlock, checker.file.program.span, checker.seq(body));
}

// What belongs to the program as a whole.
void finish(Shared& shared, CompiledProgram& into) {
  Checker& main = *shared.files.back();
  hir::Module& module = into.module;
  module.main = main.scopes.main().function;
  module.functions = into.arena->copy(shared.instances.functions());
  module.tests = into.arena->copy(main.postponed.tests());
  module.globals = into.arena->copy(shared.top_level.number_globals());
  module.unset = into.arena->copy(shared.structs.unset());
  module.global_count = static_cast<std::uint32_t>(module.globals.size());
  into.names.functions.assign(shared.mentions.all().begin(), shared.mentions.all().end());
  into.names.declared = shared.blocks.all();
}

// The bodies that could wait, and those of functions that nobody calls.
void check_functions(Checker& checker) {
  const auto work_off = [&checker] {
    while (Instance* instance = checker.shared.instances.next()) {
      check_body(*instance->declaration->file, *instance);
    }
  };
  checker.shared.instances.turn_round();
  work_off();
  for (auto& [name, function] : checker.names.functions()) {
    if (!function.instances.empty() || function.is_generic()) continue;
    checker.messages.begin_statement();
    instance_of(checker, function, function.parameters, function.node->name.span);
    work_off();
  }
}

}  // namespace

bool check_program(std::span<const FileTree> files, CompiledProgram& into, const Registry& registry,
                   const CompileOptions& options, DiagnosticSink& sink, Learnt* learnt) {
  if (into.arena == nullptr) into.arena = std::make_unique<Arena>();
  if (into.types == nullptr) into.types = std::make_unique<TypePool>();
  registry.declare_records(*into.types);
  into.messages = &registry.messages();
  Shared shared(into, registry);
  shared.learnt = learnt;
  std::deque<Checker> checkers;
  for (const FileTree& file : files)
    shared.files.push_back(&checkers.emplace_back(file, shared, into, registry, options, sink));
  Checker& main = checkers.back();
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
  for (Checker& file : checkers) check_top_level(file);
  check_waiting_tests(main);  // those of imported files are run by themselves
  for (Checker& file : checkers) check_functions(file);
  for (Checker& file : checkers) close_block(file);
  for (Checker& file : checkers) refuse_active_statements(file);
  report_later(main);
  if (!sink.has_errors()) finish_usage(main);
  if (options.open) shared.top_level.open();
  run_imports_first(main);
  finish(shared, into);
  return !sink.has_errors();
}

}  // namespace armlet::lang
