// Completions at a position: the texts that may be written there.

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "base/words.hpp"
#include "check/state/list_mutations.hpp"
#include "editor/cursor.hpp"
#include "editor/facts.hpp"
#include "editor/places.hpp"
#include "syntax/tokens/signs.hpp"
#include "syntax/tokens/token_kinds.hpp"
#include "vocabulary/language_words.hpp"
#include "vocabulary/written_call.hpp"

namespace armlet {
namespace lang {
namespace {

// Whether a name is written alone: no operator, field or group.
bool is_plain(std::string_view name) {
  return !name.empty() && std::ranges::all_of(name, is_word_character) &&
         !name.starts_with("operator");
}

class Completer {
 public:
  Completer(const Facts& facts, std::uint32_t at) : facts_(facts), cursor_(cursor_at(facts, at)) {}

  Completions run() {
    Completions out{.replaced = cursor_.word};
    if (cursor_.in_comment) return out;
    if (auto only = items_of_place(facts_, cursor_)) {
      items_ = std::move(*only);
    } else if (cursor_.quoted) {
      add_texts();
    } else if (cursor_.point) {
      add_members();
    } else {
      if (in_rows()) add_settings();
      add_names();
      add_settings();
      add_library();
    }
    out.items = std::move(items_);
    return out;
  }

 private:
  void add(std::string text, NameKind kind, std::string detail = {}) {
    if (text.empty() || !met_.insert(text).second) return;
    items_.push_back({std::move(text), kind, std::move(detail)});
  }

  // Whether the position is in a block declaration, where only its fields and rows can begin.
  [[nodiscard]] bool in_rows() const {
    return cursor_.call && cursor_.call->kind == OpenCall::Kind::kBlock &&
           cursor_.call->setting.empty();
  }

  // ---- names in scope
  void add_names() {
    const std::vector<const Symbol*> visible = facts_.visible_at(cursor_.at);
    std::vector<const Symbol*> fitting;
    const auto fits = expected_types();
    if (!fits.empty()) {
      for (const Symbol* symbol : visible) {
        if (symbol->type != nullptr && fits_any(fits, symbol->type)) fitting.push_back(symbol);
      }
    }
    for (const Symbol* symbol : fitting) add_symbol(*symbol);
    add_values_of(fits);
    for (const Symbol* symbol : visible) add_symbol(*symbol);
  }

  void add_symbol(const Symbol& symbol) {
    std::string detail = symbol.type != nullptr && !symbol.type->is(Kind::kAny)
                             ? type_name(symbol.type)
                             : std::string(symbol.header);
    add(std::string(symbol.name), symbol.kind, std::move(detail));
  }

  static bool fits_any(const std::vector<TypePattern>& patterns, const Type* type) {
    return std::ranges::any_of(patterns, [&](const TypePattern& pattern) {
      Bindings bindings;
      return match(pattern, type, false, bindings) >= 0;
    });
  }

  // The types of the parameter at the position; empty if any expression may be there.
  std::vector<TypePattern> expected_types() {
    std::vector<TypePattern> out;
    if (!cursor_.call || cursor_.call->setting.empty()) return out;
    const OpenCall& call = *cursor_.call;
    for (const NativeFunction* function : functions_of(call)) {
      const int at = facts_.signed_->signatures.of(*function).index_of(call.setting);
      if (at >= 0)
        out.push_back(
            facts_.signed_->signatures.of(*function).parameters[static_cast<std::size_t>(at)].type);
    }
    const Symbol* symbol = callee_symbol(facts_, call, cursor_.at);
    if (symbol == nullptr || !out.empty()) return out;
    for (const ast::Param& parameter : parameters_of(*symbol)) {
      if (parameter.name.text != call.setting) continue;
      const Symbol* declared = facts_.declared_at(parameter.name.span);
      if (declared != nullptr && declared->type != nullptr) out.push_back({.type = declared->type});
    }
    return out;
  }

  // The library functions whose parameters include the settings of the call.
  std::vector<const NativeFunction*> functions_of(const OpenCall& call) const {
    if (call.kind == OpenCall::Kind::kCall || call.kind == OpenCall::Kind::kBlock)
      return candidates(facts_, call);
    const auto of_block = facts_.registry->functions(call.name + '.' + std::string(call.setting));
    return {of_block.begin(), of_block.end()};
  }

  static std::span<const ast::Param> parameters_of(const Symbol& symbol) {
    if (symbol.function != nullptr) return symbol.function->params;
    if (symbol.structure != nullptr) return symbol.structure->fields;
    return {};
  }

  // Adds true and false, State.Idle ...
  void add_values_of(const std::vector<TypePattern>& patterns) {
    for (const TypePattern& pattern : patterns) {
      if (pattern.form != TypePattern::Form::kType || pattern.type == nullptr) continue;
      if (pattern.type->is(Kind::kBool)) {
        add("true", NameKind::kWord);
        add("false", NameKind::kWord);
      }
      if (!pattern.type->is(Kind::kEnum)) continue;
      for (const std::string& value : pattern.type->enumeration->values)
        add(type_name(pattern.type) + '.' + value, NameKind::kEnumValue, type_name(pattern.type));
    }
  }

  // ---- settings of the call
  void add_settings() {
    if (!cursor_.call || !cursor_.call->setting.empty() || !cursor_.call->directly) return;
    const OpenCall& call = *cursor_.call;
    const auto setting = [&](std::string_view name, std::string detail) {
      if (std::ranges::find(call.given, name) == call.given.end())
        add(std::string(name) + ':', NameKind::kSetting, std::move(detail));
    };
    if (call.kind == OpenCall::Kind::kWith || call.kind == OpenCall::Kind::kPath)
      return add_block_settings(call, setting);
    if (const Symbol* symbol = callee_symbol(facts_, call, cursor_.at)) {
      for (const ast::Param& parameter : parameters_of(*symbol))
        setting(parameter.name.text, std::string(facts_.compiled.sources->slice(parameter.span)));
    }
    for (const NativeFunction* function : candidates(facts_, call)) {
      const auto& parameters = facts_.signed_->signatures.of(*function).parameters;
      for (std::size_t i = call.behind_point ? 1 : 0; i < parameters.size(); ++i)
        setting(parameters[i].name, parameter_text(parameters[i]));
    }
    if (call.kind == OpenCall::Kind::kBlock) add_rows(call.name + '.');
  }

  std::string parameter_text(const Parameter& parameter) const {
    return pattern_name(parameter.type, {}, *facts_.compiled.types);
  }

  template <class F>
  void add_block_settings(const OpenCall& call, F setting) {
    const std::string prefix = call.name + '.';
    for (const std::string_view name : facts_.registry->public_names()) {
      if (!name.starts_with(prefix)) continue;
      const auto functions = facts_.registry->functions(name);
      setting(name.substr(prefix.size()),
              functions.empty() ? std::string() : std::string(row_of(*functions[0]).signature));
    }
    if (call.kind == OpenCall::Kind::kPath) return;
    for (const auto& [name, type] : facts_.registry->types()) {
      if (type->is_ambient) setting(name, name);
    }
  }

  // Adds rows such as phase wound(...), whose two words are part of the names of their functions.
  void add_rows(const std::string& prefix) {
    for (std::string_view name : facts_.registry->public_names()) {
      if (!name.starts_with(prefix)) continue;
      name.remove_prefix(prefix.size());
      const std::size_t point = name.find('.');
      if (point == std::string_view::npos) continue;
      add(std::string(name.substr(0, point)), NameKind::kWord);
      if (name.substr(point) != kNamedRow)
        add(std::string(name.substr(point + 1)), NameKind::kWord);
    }
  }

  // ---- the library
  void add_library() {
    for (const NativeFunction& word : language_words())
      if (is_plain(word.name))
        add(std::string(word.name), NameKind::kLibraryFunction,
            written_call(*facts_.registry, word));
    for (const std::string_view name : facts_.registry->public_names()) {
      const std::size_t point = name.find('.');
      const std::string_view group = name.substr(0, point);
      if (point != std::string_view::npos) {
        if (facts_.registry->is_namespace(group) && is_plain(group) &&
            facts_.registry->type(group) == nullptr && !is_reserved_word(group))
          add(std::string(group), NameKind::kModule);
        continue;
      }
      if (is_plain(name)) add_native(name, name);
    }
    add("Math", NameKind::kModule);
    if (!is_value_place(facts_, cursor_)) return add_types_and_words();
    for (const Word& word : kWordRows) {
      const bool stands_in_values = word.kind == WordKind::kTruth || word.kind == WordKind::kType ||
                                    word.text == "fn" || word.text == "new";
      if (stands_in_values) add(std::string(word.text), NameKind::kWord);
    }
  }

  // Adds types and keywords that cannot begin an expression.
  void add_types_and_words() {
    for (const auto& [name, type] : facts_.registry->types()) add(name, NameKind::kType);
    for (const auto& [name, fields] : facts_.registry->records())
      add(name, NameKind::kType, fields);
    for (const std::string_view name : dimension_names()) add(std::string(name), NameKind::kType);
    for (const char* name : {"string", "String", "matrix", "table", "System"})
      add(name, NameKind::kType);
    for (const Word& word : kWordRows) add(std::string(word.text), NameKind::kWord);
  }

  void add_native(std::string_view full, std::string_view shown) {
    const auto functions = facts_.registry->functions(full);
    if (functions.empty()) {
      const NativeConstant* constant = facts_.registry->constant(full);
      add(std::string(shown), constant != nullptr ? NameKind::kConstant : NameKind::kType,
          constant != nullptr ? std::string(constant->help) : std::string());
      return;
    }
    add(std::string(shown), NameKind::kLibraryFunction,
        written_call(*facts_.registry, *functions[0]));
  }

  // ---- behind a point
  void add_members() {
    const std::string group = group_before_point();
    if (!group.empty()) add_rows_of(group);
    if (const Type* type = receiver_type(facts_, *cursor_.point)) return add_members_of(*type);
    if (group.empty()) return;
    const Symbol* symbol = facts_.visible_at(cursor_.at, group);
    if (symbol != nullptr && symbol->kind == NameKind::kEnum) {
      if (symbol->enumeration != nullptr) {
        for (const ast::Name& value : symbol->enumeration->values)
          add(std::string(value.text), NameKind::kEnumValue, group);
      } else {
        for (const std::string& value : symbol->values->enumeration->values)
          add(value, NameKind::kEnumValue, group);
      }
      return add("values", NameKind::kField);
    }
    if (symbol != nullptr && symbol->kind == NameKind::kModule) return add_module(*symbol);
    if (group == "System") return add("out", NameKind::kModule);
    if (group == "System.out") {
      for (const char* name : {"println", "print", "printf"}) add(name, NameKind::kLibraryFunction);
      return;
    }
    const std::string prefix = group + '.';
    for (const std::string_view name : facts_.registry->public_names()) {
      if (name.starts_with(prefix) && is_plain(name.substr(prefix.size())))
        add_native(name, name.substr(prefix.size()));
      if (group == "Math" && is_plain(name)) add_native(name, name);
    }
  }

  // Adds the rows of a block whose rows have names.
  void add_rows_of(const std::string& block) {
    for (const ast::Stmt* stmt : facts_.files.back().program.body) {
      if (stmt->kind != ast::StmtKind::kObject) continue;
      const auto& node = stmt->as<ast::ObjectStmt>();
      if (node.name.text != block || !facts_.registry->has_named_rows(text_of_type(node))) continue;
      for (const ast::BlockItem& item : node.items)
        if (item.is_row) add(std::string(item.constructor.text), NameKind::kField);
    }
  }

  [[nodiscard]] std::string_view text_of_type(const ast::ObjectStmt& node) const {
    const Span span = node.type->span;
    return facts_.main().text().substr(span.begin, span.end - span.begin);
  }

  // The name before the point: "Math" for Math.|; empty if it is not a name.
  [[nodiscard]] std::string group_before_point() const {
    std::string out;
    std::size_t behind = facts_.token_behind(cursor_.point->begin);
    const std::string_view text = facts_.main().text();
    if (behind < facts_.tokens.size() && facts_.tokens[behind].end != cursor_.point->begin) {
      std::uint32_t first = cursor_.point->begin;  // inside a formatted text
      while (first > 0 && is_word_character(text[first - 1])) --first;
      return std::string(text.substr(first, cursor_.point->begin - first));
    }
    for (;; behind -= 2) {
      if (behind >= facts_.tokens.size() || !is_name(facts_.tokens[behind].type)) return {};
      out = std::string(facts_.text_of(facts_.tokens[behind])) + (out.empty() ? "" : ".") + out;
      if (behind < 2 || facts_.tokens[behind - 1].type != sign::kPoint) return out;
    }
  }

  void add_module(const Symbol& module) {
    for (const FileTree& file : facts_.files) {
      for (const FileTree::Import& import : file.imports) {
        const Span shown = import.statement->alias.text.empty() ? import.statement->path_span
                                                                : import.statement->alias.span;
        if (file.program.span.source != facts_.main_source() || import.file < 0 ||
            shown != module.declared)
          continue;
        const std::uint32_t source =
            facts_.files[static_cast<std::size_t>(import.file)].program.span.source;
        for (const Symbol& symbol : facts_.names.symbols) {
          if (symbol.declared.source == source && symbol.kind != NameKind::kField &&
              symbol.kind != NameKind::kEnumValue && symbol.kind != NameKind::kParameter &&
              symbol.kind != NameKind::kModule && !symbol.name.starts_with('_'))
            add_symbol(symbol);
        }
      }
    }
  }

  void add_members_of(const Type& type) {
    if (type.is(Kind::kRecord)) {
      for (const RecordField& field : type.record->fields)
        add(field.name, NameKind::kField, type_name(field.type));
      if (type.is_table()) add("length", NameKind::kField, "int");
    }
    if (type.is(Kind::kList) || type.is(Kind::kText) || type.is(Kind::kMap))
      add("length", NameKind::kField, "int");
    if (type.is(Kind::kList)) {
      add("last", NameKind::kField, type_name(type.element));
      for (const ListMutation& row : kListMutations)
        add(std::string(row.name), NameKind::kLibraryFunction);
    }
    if (type.is(Kind::kList) || type.is(Kind::kMatrix)) add("clone", NameKind::kLibraryFunction);
    if (type.is(Kind::kText)) add("equals", NameKind::kLibraryFunction);
    if (type.is(Kind::kMap)) {
      for (const char* name : {"get", "has", "keys", "values", "remove"})
        add(name, NameKind::kLibraryFunction);
    }
    if (type.is(Kind::kEnum)) add("name", NameKind::kField, "string");
    if (&type == facts_.compiled.types->library_record("error"))
      add("getMessage", NameKind::kLibraryFunction);
    const std::string prefix = type_name(&type) + '.';
    for (const std::string_view name : facts_.registry->public_names()) {
      if (name.starts_with(prefix) && is_plain(name.substr(prefix.size())))
        add_native(name, name.substr(prefix.size()));
    }
    add_functions_of(type);
  }

  // Adds functions with this type as the first parameter: x.f() is f(x).
  void add_functions_of(const Type& type) {
    for (const Symbol& symbol : facts_.names.symbols) {
      if (symbol.function == nullptr || symbol.function->params.empty()) continue;
      const Symbol* first = facts_.declared_at(symbol.function->params[0].name.span);
      const bool generic = symbol.function->params[0].type == nullptr;
      const bool fits = first != nullptr && first->type != nullptr &&
                        (first->type == &type || conversion_cost(&type, first->type) >= 0);
      if (symbol.visible.source == facts_.main_source() && (generic || fits)) add_symbol(symbol);
      if (symbol.declared.source != facts_.main_source() && fits && !symbol.name.starts_with('_'))
        add_symbol(symbol);
    }
    for (const std::string_view name : facts_.registry->public_names()) {
      if (!is_plain(name)) continue;
      for (const NativeFunction* function : facts_.registry->functions(name)) {
        const auto& parameters = facts_.signed_->signatures.of(*function).parameters;
        if (parameters.empty() || function->help.empty()) continue;
        Bindings bindings;
        if (match(parameters[0].type, &type, false, bindings) < 0 && !parameters[0].any_number)
          continue;
        add(std::string(name), NameKind::kLibraryFunction,
            written_call(*facts_.registry, *function));
        break;
      }
    }
  }

  // ---- between quotes
  void add_texts() {
    for (Completion& each : texts_of_place(facts_, cursor_))
      add(std::move(each.text), each.kind, std::move(each.detail));
    if (!cursor_.call || !facts_.options.texts) return;
    for (const NativeFunction* function : functions_of(*cursor_.call)) {
      const int at = parameter_of(facts_, *cursor_.call, *function);
      if (at < 0) continue;
      const Parameter& parameter =
          facts_.signed_->signatures.of(*function).parameters[static_cast<std::size_t>(at)];
      for (std::string& text : facts_.options.texts(*function, parameter.name))
        add(std::move(text), NameKind::kText);
    }
  }

  const Facts& facts_;
  Cursor cursor_;
  std::vector<Completion> items_;
  std::unordered_set<std::string> met_;
};

}  // namespace
}  // namespace lang

Completions Analysis::completion(std::uint32_t at) const {
  if (facts_->signed_ == nullptr) return {};
  const std::scoped_lock one_query(facts_->signed_->mutex);
  return lang::Completer(*facts_, facts_->place(at)).run();
}

}  // namespace armlet
