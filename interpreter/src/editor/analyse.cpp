// Makes the analysis of a text: parse, repair, check, index.

#include "editor/analyse.hpp"

#include <exception>
#include <new>
#include <optional>
#include <utility>

#include "armlet/core/ample_stack.hpp"
#include "base/cancelled.hpp"
#include "driver/load_files.hpp"
#include "driver/pipeline.hpp"
#include "driver/vocabulary.hpp"
#include "editor/facts.hpp"
#include "vocabulary/table_files.hpp"

namespace armlet::lang {
namespace {

// Fixes that were not tried out are marked as guesses.
std::vector<Diagnostic> as_guesses(std::vector<Diagnostic> all) {
  for (Diagnostic& diagnostic : all) {
    if (diagnostic.fix) diagnostic.fix->confidence = Confidence::kMaybe;
  }
  return all;
}

// The messages are about the statements without a mistake. Types and names are collected from all
// statements, with guesses where the text is incomplete.
void check_facts(Facts& facts, const Mended& read, DiagnosticSink& sink) {
  FileTree& main = facts.files.back();
  facts.is_whole = main.ok;
  const auto check = [&](DiagnosticSink& to, Learnt* learnt) {
    CheckedProgram into = new_program(facts.options);
    into.sources = facts.compiled.sources;
    check_program(facts.files, into, *facts.registry, facts.options, to, learnt);
    facts.compiled = std::move(into);
  };
  if (main.ok) {
    check(sink, &facts.learnt);
    if (!sink.has_errors() && !facts.learnt.leaves_out()) return;
  } else if (read.is_readable) {
    check(sink, nullptr);
  }
  if (!main.ok) main.program.body = facts.tree.copy(read.statements);
  facts.learnt = Learnt(true);
  DiagnosticSink quiet(0);
  check(quiet, &facts.learnt);
}

void analyse(Facts& facts, DiagnosticSink& sink, const Facts* before) {
  Mended main;
  std::optional<ReadBefore> known;
  if (before != nullptr && !before->read.empty() && before->main_source() == facts.main_source())
    known.emplace(before->main().text(), before->read, facts.main().text());
  facts.files = load_files(*facts.compiled.sources, facts.tree, facts.options, sink, &main,
                           known ? &*known : nullptr);
  facts.tokens = std::move(main.tokens);
  facts.comments = std::move(main.comments);
  facts.read = std::move(main.read);
  check_facts(facts, main, sink);
  facts.signed_ = std::make_unique<Signed>(*facts.registry, *facts.compiled.types);
  index_facts(facts);
}

}  // namespace

std::unique_ptr<const Analysis::Facts> analyse_text(std::shared_ptr<const Registry> registry,
                                                    std::string text, std::string name,
                                                    const CompileOptions& options,
                                                    const Facts* before) {
  std::unique_ptr<Analysis::Facts> facts;
  const auto begin_again = [&] {
    facts = std::make_unique<Analysis::Facts>(registry, options);
    facts->options.tables =
        std::make_shared<TableFiles>(before != nullptr ? before->options.tables.get() : nullptr);
    facts->compiled.sources->add(name, text);
  };
  begin_again();
  DiagnosticSink sink(options.limits.errors);
  try {
    on_ample_stack([&] { analyse(*facts, sink, before); });
    facts->diagnostics = as_guesses(sink.take_sorted());
  } catch (const Cancelled&) {
    begin_again();
    facts->cancelled = true;
    facts->diagnostics = {make_diagnostic("R0629", {})};
  } catch (const std::bad_alloc&) {
    begin_again();
    facts->diagnostics = {defect("the computer has no memory left")};
  } catch (const std::exception& e) {
    begin_again();
    facts->diagnostics = {defect(e.what())};
  }
  facts->options.cancelled = nullptr;
  facts->options.host = nullptr;
  return facts;
}

}  // namespace armlet::lang

namespace armlet {

std::shared_ptr<const Analysis> Engine::analyse(
    std::string text, std::string name, const CompileOptions& options,
    const std::shared_ptr<const Analysis>& before) const {
  return std::make_shared<const Analysis>(
      lang::analyse_text(registry_, std::move(text), std::move(name), options,
                         before != nullptr ? &before->facts() : nullptr));
}

}  // namespace armlet
