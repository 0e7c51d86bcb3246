// Information about the name or value at a position: description, declaration, uses.

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "armlet/interpreter/unit.hpp"
#include "base/quotes.hpp"
#include "editor/cursor.hpp"
#include "editor/facts.hpp"
#include "editor/places.hpp"
#include "editor/symbol_at.hpp"
#include "syntax/tokens/signs.hpp"
#include "syntax/tokens/token_kinds.hpp"
#include "vm/heap/format_value.hpp"
#include "vocabulary/language_words.hpp"
#include "vocabulary/written_call.hpp"

namespace armlet {
namespace lang {
namespace {

std::string amount_text(double si, Dim dim) {
  return dim.is_none() ? number_text(si) : quantity_text(si, dim);
}

std::string shown(const Constant& value, const Type* type) {
  switch (value.kind) {
    case Constant::Kind::kBool:
      return value.truth ? "true" : "false";
    case Constant::Kind::kInt:
      if (type == nullptr || !type->is(Kind::kReal)) return std::to_string(value.integer);
      return amount_text(value.real, type->dim);
    case Constant::Kind::kReal:
      return amount_text(value.real, type != nullptr ? type->dim : Dim{});
    case Constant::Kind::kText:
      return '"' + value.text + '"';
    case Constant::Kind::kList: {
      constexpr std::size_t kMost = 8;
      std::string out = "[";
      const Type* element = type != nullptr ? type->element : nullptr;
      for (std::size_t i = 0; i < value.items.size() && i < kMost; ++i)
        out += (i == 0 ? "" : ", ") + shown(value.items[i], element);
      return out + (value.items.size() > kMost ? ", ...]" : "]");
    }
  }
  return {};
}

template <class Functions>
void add_functions(const Facts& facts, Hover& out, const Functions& functions) {
  for (const NativeFunction* each : functions) {
    const NativeFunction* function = &row_of(*each);
    const std::string call = written_call(*facts.registry, *function);
    if (call.empty() || function->help.empty()) continue;
    if (out.text.find(call) == std::string::npos) out.text += (out.text.empty() ? "" : "\n") + call;
    if (out.help.find(function->help) == std::string::npos)
      out.help += (out.help.empty() ? "" : "\n") + std::string(function->help);
    if (!function->example.empty() && out.help.find(function->example) == std::string::npos)
      out.help += "\nExample: " + std::string(function->example);
  }
}

std::string word_help(const Facts& facts, std::string_view name, std::string& help) {
  if (const NativeConstant* constant = facts.registry->constant(name)) {
    help = constant->help;
    return fmt::format("{} = {}", name, amount_text(constant->value, constant->dim));
  }
  if (facts.registry->type(name) != nullptr || facts.registry->records().contains(name) ||
      dimension_named(name)) {
    const auto record = facts.registry->records().find(name);
    return fmt::format(
        "type {}{}", name,
        record == facts.registry->records().end() ? "" : " { " + record->second + " }");
  }
  return {};
}

// The description of a name of the library, found by its text.
std::optional<Hover> library_hover(const Facts& facts, const Token& token) {
  const std::string name(facts.text_of(token));
  Hover out{.span = {token.begin, token.end, 0}};
  std::vector<const NativeFunction*> words;
  for (const NativeFunction& word : language_words()) {
    if (word.name == name) words.push_back(&word);
  }
  const std::size_t behind = facts.token_behind(token.end);
  std::string full = name;
  for (std::size_t i = behind;
       i >= 2 && facts.tokens[i - 1].type == sign::kPoint && is_name(facts.tokens[i - 2].type);
       i -= 2)
    full = std::string(facts.text_of(facts.tokens[i - 2])) + '.' + full;
  add_functions(facts, out, words);
  add_functions(facts, out, facts.registry->functions(full));
  if (out.text.empty()) add_functions(facts, out, facts.registry->functions(name));
  if (out.text.empty()) add_functions(facts, out, facts.registry->functions(name + "{}"));
  if (out.text.empty()) out.text = word_help(facts, full, out.help);
  if (out.text.empty()) out.text = word_help(facts, name, out.help);
  return out.text.empty() ? std::nullopt : std::optional(out);
}

// The description of a name in the position of a type.
std::optional<Hover> type_hover(const Facts& facts, const Token& token, std::size_t index) {
  if (!is_type_place(facts, index)) return std::nullopt;
  const std::string name(facts.text_of(token));
  Hover out{.span = {token.begin, token.end, 0}, .text = word_help(facts, name, out.help)};
  const bool is_builtin = is_primitive_type(token.type) || name == "string" || name == "matrix";
  if (out.text.empty() && is_builtin) out.text = "type " + name;
  if (const auto dim = dimension_named(name)) {
    out.help = "Units:";
    for (const std::string_view unit : units_of(dim)) out.help += ' ' + std::string(unit);
  }
  return out.text.empty() ? std::nullopt : std::optional(out);
}

// The declarations of an imported file, for its `import`.
std::optional<Hover> import_hover(const Facts& facts, std::uint32_t at) {
  for (const FileTree::Import& import : facts.files.back().imports) {
    const Span path = import.statement->path_span;
    if (at < path.begin || at > path.end || import.file < 0) continue;
    Hover out{.span = path, .text = "file " + std::string(facts.compiled.sources->slice(path))};
    const Span whole = facts.files[static_cast<std::size_t>(import.file)].program.span;
    for (const Symbol& symbol : facts.names.symbols) {
      const bool is_shown = symbol.kind == NameKind::kFunction ||
                            symbol.kind == NameKind::kStruct || symbol.kind == NameKind::kEnum;
      if (symbol.declared.source == whole.source && is_shown && !symbol.name.starts_with('_'))
        out.help += (out.help.empty() ? "" : "\n") + std::string(symbol.header);
    }
    return out;
  }
  return std::nullopt;
}

// The description of a text with a meaning: a kind of error, or a choice of a setting.
std::optional<Hover> text_hover(const Facts& facts, const Token& token, std::size_t index,
                                std::uint32_t at) {
  const std::string_view text = facts.text_of(token);
  if (token.type != sign::kText || text.size() < 2) return std::nullopt;
  const std::string_view name = inside_quotes(text);
  Hover out{.span = {token.begin, token.end, 0}};
  if (is_kind_place(facts, index)) {
    const CatalogEntry* entry = facts.registry->messages().of_kind(name);
    out.text = fmt::format("kind \"{}\"", name);
    if (entry != nullptr) out.help = entry->page.substr(0, entry->page.find("\n\n"));
    return out;
  }
  const Cursor cursor = cursor_at(facts, std::max(at, token.begin + 1));
  if (!cursor.call || cursor.call->kind != OpenCall::Kind::kWith) return std::nullopt;
  const std::string setting = cursor.call->name + '.' + std::string(cursor.call->setting);
  for (const NativeFunction* function : facts.registry->functions(setting)) {
    out.text = std::string(cursor.call->setting) + ": string";
    out.help = function->help;
  }
  return out.text.empty() ? std::nullopt : std::optional(out);
}

// The description of a number with a unit: its dimension, and its value in SI units.
std::optional<Hover> quantity_hover(const Facts& facts, const Token& token) {
  const std::string_view text = facts.text_of(token);
  const auto quantity = is_number(token.type) ? parse_quantity(text) : std::nullopt;
  if (!quantity || quantity->dim.is_none()) return std::nullopt;
  return Hover{.span = {token.begin, token.end, 0},
               .text = dimension_name(quantity->dim),
               .help = fmt::format("{} = {} {}", text, bare_number_text(quantity->si),
                                   si_unit(quantity->dim))};
}

// The description of a map entry, at its key.
std::optional<Hover> key_hover(const Facts& facts, const Token& token, std::size_t index) {
  if (token.type != sign::kText || index < 2 || facts.text_of(facts.tokens[index - 1]) != "[")
    return std::nullopt;
  const auto& spans = facts.values.spans;  // the outer ones first
  const auto found = std::find_if(spans.rbegin(), spans.rend(), [&](const TypedSpan& each) {
    return each.span.begin < token.begin && token.end < each.span.end &&
           each.span.end == facts.tokens[index + 1].end;
  });
  if (found == spans.rend() || found->type->is(Kind::kAny)) return std::nullopt;
  return Hover{.span = {token.begin, token.end, 0},
               .text = fmt::format("{}: {}", facts.compiled.sources->slice(found->span),
                                   type_name(found->type))};
}

std::optional<Hover> native_hover(const Facts& facts, const Learnt::NativeUse& use) {
  Hover out{.span = use.name};
  if (use.parameter < 0) {
    const NativeFunction* chosen[] = {&row_of(*use.function)};
    add_functions(facts, out, chosen);
    std::set<const NativeFunction*> rows;
    for (const NativeFunction* function : facts.registry->functions(use.function->name))
      rows.insert(&row_of(*function));
    const std::size_t overloads = rows.size();
    if (!out.text.empty() && overloads > 1)
      out.help += fmt::format("\nThis is one of {} forms.", overloads);
  } else {
    const Parameter& parameter = facts.signed_->signatures.of(*use.function)
                                     .parameters[static_cast<std::size_t>(use.parameter)];
    out.text = parameter.name + ": " + pattern_name(parameter.type, {}, *facts.compiled.types);
    out.help = "A setting of " + written_call(*facts.registry, *use.function);
  }
  return out.text.empty() ? std::nullopt : std::optional(out);
}

std::optional<Hover> value_hover(const Facts& facts, std::uint32_t at) {
  const std::uint32_t found = facts.values.innermost.at(at);
  if (found == InnermostSpans::kNothing) return std::nullopt;
  const TypedSpan& value = facts.values.spans[found];
  if (value.type->is(Kind::kAny) || value.type->is(Kind::kVoid)) return std::nullopt;
  return Hover{.span = value.span, .text = type_name(value.type)};
}

std::optional<Hover> symbol_hover(const Facts& facts, Span at, const Symbol& symbol) {
  Hover out{.span = at, .text = described(facts, symbol), .help = std::string(symbol.doc)};
  if (const Constant* value = facts.learnt.constant_at(symbol.declared))
    out.value = shown(*value, symbol.type);
  return out;
}

// The symbol of a name for which no use was noted, such as one in a statement that failed.
const Symbol* symbol_called(const Facts& facts, const Token& token, std::size_t index) {
  if (!is_name(token.type) || (index > 0 && facts.tokens[index - 1].type == sign::kPoint))
    return nullptr;
  return facts.visible_at(token.begin, facts.text_of(token));
}

std::optional<Hover> name_hover(const Facts& facts, std::uint32_t at) {
  const Learnt::NativeUse* native = facts.native_at(at);
  const Reference* reference = facts.reference_at(at);
  if (reference != nullptr && (native == nullptr || native->name.begin <= reference->name.begin))
    return symbol_hover(facts, reference->name, facts.names.symbols[reference->symbol]);
  if (native != nullptr) {
    if (auto out = native_hover(facts, *native)) return out;
  }
  if (auto out = import_hover(facts, at)) return out;
  const std::size_t index = facts.token_behind(at == 0 ? 0 : at);
  for (std::size_t i = index; i < facts.tokens.size() && i <= index + 1; ++i) {
    const Token& token = facts.tokens[i];
    if (token.begin > at || at > token.end || token.type == kEndOfText) continue;
    if (auto out = text_hover(facts, token, i, at)) return out;
    if (auto out = quantity_hover(facts, token)) return out;
    if (auto out = key_hover(facts, token, i)) return out;
    if (const Symbol* symbol = symbol_called(facts, token, i))
      return symbol_hover(facts, {token.begin, token.end, 0}, *symbol);
    if (auto out = type_hover(facts, token, i)) return out;
    const bool is_word = is_name(token.type) || !word_of(token.type).text.empty();
    if (is_word && (at < token.end || i == index)) {
      if (auto out = library_hover(facts, token)) return out;
    }
  }
  return value_hover(facts, at);
}

}  // namespace

// The symbol that the name at a byte refers to.
const Symbol* symbol_at(const Facts& facts, std::uint32_t at) {
  if (facts.in_comment(at)) return nullptr;
  if (const Reference* reference = facts.reference_at(at))
    return &facts.names.symbols[reference->symbol];
  const std::size_t index = facts.token_behind(at);
  for (std::size_t i = index; i < facts.tokens.size() && i <= index + 1; ++i) {
    const Token& token = facts.tokens[i];
    if (token.begin > at || at > token.end) continue;
    if (const Symbol* symbol = symbol_called(facts, token, i)) return symbol;
  }
  return nullptr;
}

}  // namespace lang

std::optional<Hover> Analysis::hover(std::uint32_t at) const {
  if (facts_->signed_ == nullptr) return std::nullopt;
  const std::scoped_lock one_query(facts_->signed_->mutex);
  at = facts_->place(at);
  std::optional<Hover> out;
  if (!facts_->in_comment(at)) out = lang::name_hover(*facts_, at);
  std::vector<std::string> messages;
  Span marked{};
  for (const Diagnostic& diagnostic : facts_->diagnostics) {
    const Span span = diagnostic.mark.span;
    if (span.source != facts_->main_source() || at < span.begin || at > span.end) continue;
    marked = span;
    messages.push_back(diagnostic.code + ": " + diagnostic.message);
  }
  if (messages.empty()) return out;
  if (!out) out = Hover{.span = marked};
  out->messages = std::move(messages);
  return out;
}

std::optional<Span> Analysis::definition(std::uint32_t at) const {
  const lang::Symbol* symbol = lang::symbol_at(*facts_, facts_->place(at));
  return symbol != nullptr ? std::optional(symbol->declared) : std::nullopt;
}

std::vector<Span> Analysis::references(std::uint32_t at) const {
  const lang::Symbol* symbol = lang::symbol_at(*facts_, facts_->place(at));
  if (symbol == nullptr) return {};
  std::vector<Span> out;
  for (const lang::Reference& use : facts_->uses_of(*symbol)) out.push_back(use.name);
  return out;
}

std::vector<InlayHint> Analysis::inlay_hints() const {
  std::vector<InlayHint> out;
  for (const lang::Symbol& symbol : facts_->names.symbols) {
    const bool is_known = symbol.type != nullptr && !symbol.type->is(Kind::kAny);
    if (symbol.kind != NameKind::kVariable || !is_known ||
        symbol.declared.source != facts_->main_source())
      continue;
    if (!symbol.is_typed) out.push_back({symbol.declared.end, ": " + type_name(symbol.type)});
  }
  return out;
}

}  // namespace armlet
