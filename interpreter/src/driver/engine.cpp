#include "armlet/interpreter/engine.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/define_type.hpp"
#include "armlet/interpreter/render.hpp"
#include "driver/definitions.hpp"
#include "driver/pipeline.hpp"
#include "driver/vocabulary.hpp"
#include "program/program.hpp"
#include "syntax/parse.hpp"

namespace armlet {

// ---- Engine

Engine::Engine() : registry_(std::make_shared<Vocabulary>()) {}
Engine::~Engine() = default;
Engine::Engine(Engine&&) noexcept = default;
Engine& Engine::operator=(Engine&&) noexcept = default;

Engine::Vocabulary& Engine::vocabulary() const {
  if (registry_ == nullptr)
    throw ArgumentError("This Engine has been moved from; use the one that it was moved into.");
  return *registry_;
}

namespace {

[[noreturn]] void refuse_again(std::string_view what, std::string_view name) {
  throw ArgumentError("The " + std::string(what) + " `" + std::string(name) +
                      "` is known to this engine already.");
}

// Throws the error that `what` cannot be defined, with the reasons.
[[noreturn]] void refuse(std::string_view what, std::string_view name,
                         const std::vector<std::string>& faults) {
  std::string all = "The " + std::string(what) + " `" + std::string(name) + "` cannot be defined: ";
  for (std::size_t i = 0; i < faults.size(); ++i) all += (i == 0 ? "" : "; ") + faults[i];
  throw ArgumentError(all + '.');
}

}  // namespace

Engine& Engine::add_functions(std::span<const NativeFunction> functions, std::string_view chapter) {
  if (const NativeFunction* there = vocabulary().add_functions(functions)) {
    refuse_again("function", std::string(there->name) + std::string(there->signature));
  }
  vocabulary().add_chapter({chapter, functions, {}});
  return *this;
}

Engine& Engine::only_values(std::span<const NativeFunction> functions) {
  vocabulary().add_values(functions);
  return *this;
}

Engine& Engine::define(const Definition& definition, std::string_view chapter) {
  const std::vector<std::string> faults = lang::faults_of(vocabulary(), definition.function);
  if (!faults.empty()) refuse("function", definition.function.name, faults);
  return add_functions(vocabulary().keep(definition.function, definition.kept), chapter);
}

Engine& Engine::define(const TypeDefinition& definition, std::string_view chapter) {
  const std::vector<std::string> faults = lang::add_type(vocabulary(), definition);
  if (!faults.empty()) refuse("type", definition.type().name, faults);
  vocabulary().add_chapter({chapter, definition.functions(), {}});
  return *this;
}

Engine& Engine::add_constants(std::span<const NativeConstant> constants, std::string_view chapter) {
  std::set<std::string_view> met;
  for (const NativeConstant& constant : constants) {
    if (!met.insert(constant.name).second || vocabulary().constant(constant.name) != nullptr)
      refuse_again("constant", constant.name);
  }
  vocabulary().add_chapter({chapter, {}, constants});
  for (const NativeConstant& constant : constants) vocabulary().add_constant(constant);
  return *this;
}

Engine& Engine::add_type(const HostType& type) {
  if (vocabulary().type(type.name) != nullptr) refuse_again("type", type.name);
  vocabulary().add_type(type);
  return *this;
}

Engine& Engine::add_record(std::string_view name, std::string_view fields) {
  if (vocabulary().records().contains(name)) refuse_again("record", name);
  vocabulary().add_record(name, fields);
  return *this;
}

Engine& Engine::add_messages(std::span<const CatalogEntry> rows) {
  vocabulary().add_messages(rows);
  return *this;
}

Engine& Engine::add_foreign_names(std::span<const ForeignName> rows) {
  vocabulary().add_foreign_names(rows);
  return *this;
}

const MessageTables& Engine::messages() const { return vocabulary().messages(); }

bool is_complete(std::string_view text, std::string_view next_line) {
  const std::string entry(text);
  if (!lang::is_complete(Source("entry", entry))) return false;
  return next_line.empty() || !lang::goes_on(Source("entry", entry + '\n' + std::string(next_line)),
                                             static_cast<std::uint32_t>(entry.size()));
}

Compilation Engine::compile(std::string text, std::string name,
                            const CompileOptions& options) const {
  if (options.after != nullptr && !options.after->is_entry())
    throw ArgumentError(
        "A text can be an entry only behind an entry: the one before was compiled without "
        "CompileOptions::is_entry.");
  if (options.after != nullptr && options.after->compiled().messages != &vocabulary().messages())
    throw ArgumentError("An entry is compiled by the engine that compiled the one before it.");
  const lang::LowerOptions lowering{.optimise = !options.markers, .markers = options.markers};
  Compilation made =
      lang::compile_text(vocabulary(), std::move(text), std::move(name), options, lowering);
  if (made.program == nullptr) return made;
  struct Kept {
    std::shared_ptr<const Program> program;
    std::shared_ptr<const lang::Registry> vocabulary;
  };
  auto kept = std::make_shared<const Kept>(Kept{std::move(made.program), registry_});
  made.program = {kept, kept->program.get()};
  return made;
}

std::vector<std::string> Engine::check_signatures() const {
  return lang::check_signatures(vocabulary());
}

// ---- Compilation

std::string Compilation::text() const {
  std::string out;
  for (const Diagnostic& diagnostic : diagnostics) out += render_text(diagnostic, *sources);
  return out;
}

}  // namespace armlet
