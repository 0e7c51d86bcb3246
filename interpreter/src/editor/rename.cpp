// Renames a symbol and all references to it.

#include <algorithm>

#include "base/words.hpp"
#include "editor/facts.hpp"
#include "editor/symbol_at.hpp"

namespace armlet {
namespace lang {
namespace {

bool can_name_something(std::string_view text) {
  return !text.empty() && !(text[0] >= '0' && text[0] <= '9') &&
         std::ranges::all_of(text, is_word_character) && !is_reserved_word(text);
}

bool is_in_library(const Registry& registry, std::string_view name) {
  return !registry.functions(name).empty() || registry.constant(name) != nullptr ||
         registry.type(name) != nullptr || registry.is_namespace(name) ||
         registry.records().contains(name) || dimension_named(name).has_value();
}

// Fields and values of enums are named after a point, so other names do not conflict with them.
bool is_member(NameKind kind) { return kind == NameKind::kField || kind == NameKind::kEnumValue; }

// A symbol with the new name that would hide the renamed symbol at one of its uses, or be hidden by
// it; null if there is none.
const Symbol* in_the_way(const Facts& facts, const Symbol& symbol, std::string_view name) {
  for (const Symbol& other : facts.names.symbols) {
    if (other.name != name || is_member(other.kind) != is_member(symbol.kind)) continue;
    if (is_member(symbol.kind)) return &other;
    if (other.visible.source != symbol.visible.source) continue;
    const bool apart =
        other.visible.end < symbol.visible.begin || symbol.visible.end < other.visible.begin;
    if (!apart || other.of_file || symbol.of_file) return &other;
  }
  return nullptr;
}

Renaming refuse(std::string why) { return {.why = std::move(why)}; }

}  // namespace

Renaming renamed(const Facts& facts, std::uint32_t at, std::string_view name) {
  const Symbol* symbol = symbol_at(facts, at);
  if (symbol == nullptr) return refuse("nothing that the program declares stands here");
  if (symbol->declared.source < facts.main_source())
    return refuse("an earlier entry of the session declares it, and that has run");
  if (symbol->kind == NameKind::kModule)
    return refuse("a file is called by its import; write import ... as NAME");
  const std::string quoted = '`' + std::string(name) + '`';
  if (!can_name_something(name)) return refuse(quoted + " cannot be a name");
  if (is_in_library(*facts.registry, name) && !is_member(symbol->kind))
    return refuse(quoted + " is a name of the library");
  if (name == symbol->name) return {};
  if (!facts.is_whole)
    return refuse("the program has mistakes, so that not all uses of the name are known");
  if (const Symbol* other = in_the_way(facts, *symbol, name)) {
    const int line = facts.compiled.sources->position(other->declared).line;
    return refuse(quoted + " is declared already, on line " + std::to_string(line));
  }
  Renaming out;
  for (const Reference& use : facts.uses_of(*symbol))
    out.edits.push_back({use.name, std::string(name)});
  return out;
}

}  // namespace lang

Renaming Analysis::rename(std::uint32_t at, std::string_view name) const {
  return lang::renamed(*facts_, facts_->place(at), name);
}

}  // namespace armlet
