#include "driver/pipeline.hpp"

#include <exception>
#include <map>
#include <new>
#include <optional>
#include <utility>

#include "armlet/core/ample_stack.hpp"
#include "base/cancelled.hpp"
#include "check/check.hpp"
#include "driver/explained_habits.hpp"
#include "driver/load_files.hpp"
#include "driver/tried_fixes.hpp"
#include "hir/kept.hpp"
#include "vocabulary/table_files.hpp"

namespace armlet::lang {

namespace {

// Drops the type pool of an entry that has made no types, as most entries.
void close_types(CompiledProgram& entry) {
  if (entry.after != nullptr && entry.types->adds_nothing()) {
    entry.types = entry.after->compiled().types;
  } else {
    entry.types->close();
  }
}

// Compiles a program that passed all checks; null if there were errors.
std::shared_ptr<const Program> build(const Registry& registry, CheckedProgram checked,
                                     const CompileOptions& options, LowerOptions lowering,
                                     DiagnosticSink& sink) {
  auto tree = std::make_unique<Arena>();
  const std::vector<FileTree> files = load_files(*checked.sources, *tree, options, sink);
  // The program is checked even after mistakes of syntax, to report its other mistakes too.
  if (!check_program(files, checked, registry, options, sink) || !files.back().ok) return nullptr;
  lowering.cancelled = options.cancelled;
  Lowered lowered = lower(std::move(checked), lowering, options.after);
  if (lowered.too_large) {
    sink.report(*std::move(lowered.too_large));
    return nullptr;
  }
  std::unique_ptr<Program::Code>& compiled = lowered.program;
  if (compiled->entry.keeps_syntax) compiled->entry.syntax = std::move(tree);
  if (compiled->entry.is_one) close_types(*compiled);
  return std::make_shared<const Program>(std::move(compiled));
}

// Calls the host's loader. The text of an exception becomes the reason why there is no text.
ImportedText asked(const ModuleLoader& load, const std::string& path, const std::string& from) {
  try {
    return load(path, from);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& thrown) {
    return {.name = path, .why = std::string("the host that loads files failed: ") + thrown.what()};
  } catch (...) {
    return {.name = path, .why = "the host that loads files failed"};
  }
}

// A loader that calls the host's loader once for each file.
ModuleLoader remembered(const ModuleLoader& load) {
  if (!load) return load;
  using Question = std::pair<std::string, std::string>;
  return [&load, known = std::make_shared<std::map<Question, ImportedText>>()](
             const std::string& path, const std::string& from) {
    const auto [at, is_new] = known->try_emplace({path, from});
    if (is_new) at->second = asked(load, path, from);
    return at->second;
  };
}

}  // namespace

Diagnostic defect(const char* what) {
  Diagnostic d = make_diagnostic("E0198", {});
  d.why = std::string("Armlet itself failed: ") + what;
  return d;
}

Compilation compile_text(const Registry& registry, std::string text, std::string name,
                         const CompileOptions& options, LowerOptions lowering) {
  Compilation result;
  DiagnosticSink sink(options.limits.errors);
  CheckedProgram checked = new_program(options);
  result.sources = checked.sources;
  checked.what_takes_time = what_takes_time(registry);
  checked.sources->add(std::move(name), std::move(text));
  try {
    CompileOptions once = options;
    once.load = remembered(options.load);
    once.tables = std::make_shared<TableFiles>();
    on_ample_stack([&] {
      result.program = build(registry, std::move(checked), once, lowering, sink);
      result.diagnostics = sink.take_sorted();
      Trials fixes(registry, *result.sources, once);
      drop_useless_fixes(result.diagnostics, fixes);
      Trials causes(registry, *result.sources, once);
      explain_habits(result.diagnostics, *result.sources, causes);
    });
  } catch (const Cancelled&) {
    result.cancelled = true;
    result.program = nullptr;
    result.diagnostics = {make_diagnostic("R0629", {})};
  } catch (const std::bad_alloc&) {
    result.diagnostics.push_back(defect("the computer has no memory left"));
  } catch (const std::exception& e) {
    result.diagnostics.push_back(defect(e.what()));
  }
  return result;
}

}  // namespace armlet::lang
