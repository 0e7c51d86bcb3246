// Sorts the names, scopes and values of the trees in the order of the text.

#include <algorithm>
#include <tuple>

#include "ast/ast_walk.hpp"
#include "check/names/imports.hpp"
#include "editor/facts.hpp"
#include "hir/kept.hpp"

namespace armlet::lang {
namespace {

constexpr std::size_t kLongestHeader = 160;  // bytes of a struct or enum that is shown in full

auto position(Span span) { return std::tuple(span.source, span.begin); }

// Removes equal neighbours, except the first. (clang 14 cannot compile std::ranges::unique of g++
// 12.)
template <typename T, typename Part>
void keep_first(std::vector<T>& list, Part T::*part) {
  const auto same = [part](const T& a, const T& b) { return a.*part == b.*part; };
  list.erase(std::unique(list.begin(), list.end(), same), list.end());
}

// `text` without the characters before a body: blanks, `=>`, opening parentheses.
std::string_view without_tail(std::string_view text) {
  const auto trim = [&](std::string_view what) {
    text = text.substr(0, text.find_last_not_of(what) + 1);
  };
  trim(" \t\r\n(");
  if (text.ends_with("=>")) text.remove_suffix(2);
  trim(" \t\r\n");
  return text;
}

class Indexer {
 public:
  explicit Indexer(Facts& facts) : facts_(facts) {}

  void run() {
    for (const FileTree& file : facts_.files) {
      main_ = file.program.span.source == facts_.main_source();
      if (main_) scopes_.push_back(file.program.span);
      for (const FileTree::Import& import : file.imports) add_import(*import.statement);
      for (const ast::Stmt* stmt : file.program.body) walk(*stmt);
    }
    add_variables();
    add_earlier();
    finish_symbols();
    add_references();
    add_natives();
    add_values();
    std::ranges::sort(facts_.members, {}, [](const auto* m) { return position(m->member.span); });
    std::ranges::sort(facts_.functions, {}, &Span::begin);
  }

 private:
  // ---- the trees
  void walk(const ast::Stmt& stmt) {
    note(stmt);
    ast::for_each_part(
        stmt, [this](const ast::Expr& e) { walk(e); }, [this](const ast::Stmt& s) { walk(s); });
  }
  void walk(const ast::Expr& expr) {
    if (main_ && expr.kind == ast::ExprKind::kMember)
      facts_.members.push_back(&expr.as<ast::MemberExpr>());
    if (expr.kind == ast::ExprKind::kLambda) {
      const bool has_block = expr.as<ast::LambdaExpr>().body != nullptr;
      add_scope(has_block ? expr.span : with_blanks(expr.span));
    }
    ast::for_each_part(
        expr, [this](const ast::Expr& e) { walk(e); }, [this](const ast::Stmt& s) { walk(s); });
  }

  void note(const ast::Stmt& stmt) {
    using ast::StmtKind;
    switch (stmt.kind) {
      case StmtKind::kBlock:
      case StmtKind::kFor:
      case StmtKind::kForIn:
      case StmtKind::kSwitch:
        return add_scope(stmt.span);
      case StmtKind::kTest:
        if (main_) facts_.functions.push_back(stmt.span);
        return;
      case StmtKind::kTry:
        for (const ast::CatchClause& clause : stmt.as<ast::TryStmt>().catches) {
          if (!clause.name.text.empty())
            add_scope({clause.name.span.begin, clause.body->span.end, stmt.span.source});
        }
        return;
      case StmtKind::kVar:
        for (const ast::Declarator& at : stmt.as<ast::VarStmt>().declarators) {
          known_from(at.name, at.init != nullptr ? at.init->span.end : at.name.span.end,
                     stmt.as<ast::VarStmt>().doc, at.type == nullptr);
        }
        return;
      case StmtKind::kObject:
        return known_from(stmt.as<ast::ObjectStmt>().name, stmt.span.end,
                          stmt.as<ast::ObjectStmt>().doc);
      case StmtKind::kFunction:
        return add_function(stmt.as<ast::FunctionStmt>());
      case StmtKind::kStruct:
        return add_struct(stmt.as<ast::StructStmt>());
      case StmtKind::kEnum:
        return add_enum(stmt.as<ast::EnumStmt>());
      case StmtKind::kEmpty:
      case StmtKind::kImport:
      case StmtKind::kIf:
      case StmtKind::kWhile:
      case StmtKind::kDo:
      case StmtKind::kParallel:
      case StmtKind::kWhen:
      case StmtKind::kEvery:
      case StmtKind::kWith:
      case StmtKind::kPath:
      case StmtKind::kRecord:
      case StmtKind::kExpr:
      case StmtKind::kAssign:
      case StmtKind::kStep:
      case StmtKind::kWait:
      case StmtKind::kWaitUntil:
      case StmtKind::kBreak:
      case StmtKind::kContinue:
      case StmtKind::kRetry:
      case StmtKind::kReturn:
      case StmtKind::kThrow:
        return;
    }
  }

  // The span of a value with the blanks after it, so that a word after a blank at its end finds the
  // value.
  [[nodiscard]] Span with_blanks(Span span) const {
    if (!main_) return span;
    const std::string_view text = facts_.main().text();
    while (span.end < text.size() && (text[span.end] == ' ' || text[span.end] == '\t')) ++span.end;
    return span;
  }

  void add_scope(Span span) {
    if (main_) scopes_.push_back(span);
  }

  void known_from(const ast::Name& name, std::uint32_t from, std::string_view doc,
                  bool has_hint = false) {
    declared_.push_back({name.span, from, doc, has_hint});
  }

  // The symbol of a name that is visible in the whole file.
  Symbol of_file(NameKind kind, const ast::Name& name, std::string_view doc) const {
    Symbol out{.kind = kind, .name = name.text, .declared = name.span, .of_file = true};
    out.doc = doc;
    if (main_) {
      out.visible = facts_.files.back().program.span;
      out.scope = out.visible.end;
    }
    return out;
  }

  std::string_view slice(std::uint32_t begin, std::uint32_t end, std::uint32_t source) const {
    return facts_.compiled.sources->slice({begin, std::max(begin, end), source});
  }

  std::string_view head(const ast::Stmt& stmt, const ast::Name& name, std::uint32_t end) const {
    const bool is_short = stmt.span.end - stmt.span.begin <= kLongestHeader;
    return slice(stmt.span.begin, is_short ? stmt.span.end : std::max(name.span.end, end),
                 stmt.span.source);
  }

  void add_function(const ast::FunctionStmt& node) {
    if (main_) {
      facts_.functions.push_back(node.span);
      scopes_.push_back(node.span);
    }
    Symbol out = of_file(NameKind::kFunction, node.name, node.doc);
    const std::uint32_t end = node.body != nullptr ? node.body->span.begin : node.value->span.begin;
    out.header = without_tail(slice(node.span.begin, end, node.span.source));
    out.function = &node;
    facts_.names.symbols.push_back(out);
  }

  void add_struct(const ast::StructStmt& node) {
    Symbol out = of_file(NameKind::kStruct, node.name, node.doc);
    out.header = head(node, node.name, 0);
    out.structure = &node;
    facts_.names.symbols.push_back(out);
    const Type* type = facts_.learnt.structure_of(node);
    for (std::size_t i = 0; i < node.fields.size(); ++i) {
      const bool known = type != nullptr && i < type->record->fields.size();
      facts_.names.symbols.push_back({.kind = NameKind::kField,
                                      .name = node.fields[i].name.text,
                                      .declared = node.fields[i].name.span,
                                      .type = known ? type->record->fields[i].type : nullptr});
    }
  }

  void add_enum(const ast::EnumStmt& node) {
    Symbol out = of_file(NameKind::kEnum, node.name, node.doc);
    out.header = head(node, node.name, 0);
    out.enumeration = &node;
    facts_.names.symbols.push_back(out);
    for (const ast::Name& value : node.values) {
      facts_.names.symbols.push_back({.kind = NameKind::kEnumValue,
                                      .name = value.text,
                                      .declared = value.span,
                                      .header = node.name.text});
    }
  }

  void add_import(const ast::ImportStmt& node) {
    const bool has_alias = !node.alias.text.empty();
    ast::Name name{facts_.tree.copy(imported_as(node)),
                   has_alias ? node.alias.span : node.path_span};
    Symbol out = of_file(NameKind::kModule, name, {});
    out.header = slice(node.span.begin, node.span.end, node.span.source);
    facts_.names.symbols.push_back(out);
  }

  // ---- variables
  void add_variables() {
    std::ranges::sort(scopes_, {}, [](Span s) { return std::tuple(s.begin, 0xFFFFFFFFU - s.end); });
    std::ranges::sort(declared_, {}, [](const Declared& d) { return position(d.name); });
    const InnermostSpans innermost(scopes_);
    for (const hir::Variable* variable : facts_.learnt.variables()) {
      Symbol out{.kind = variable->is_parameter ? NameKind::kParameter : NameKind::kVariable,
                 .name = variable->name,
                 .declared = variable->declared,
                 .type = variable->type,
                 .is_typed = true};
      const auto known =
          std::ranges::lower_bound(declared_, position(out.declared), {},
                                   [](const Declared& d) { return position(d.name); });
      std::uint32_t from = out.declared.end;
      if (known != declared_.end() && known->name == out.declared) {
        from = known->from;
        out.doc = known->doc;
        out.is_typed = !known->has_hint;
      }
      if (out.declared.source == facts_.main_source() && out.declared.begin < out.declared.end)
        see(out, innermost.at(out.declared.begin), from);
      facts_.names.symbols.push_back(out);
    }
  }

  void see(Symbol& symbol, std::uint32_t scope, std::uint32_t from) const {
    const Span span = scope == InnermostSpans::kNothing ? scopes_.front() : scopes_[scope];
    const std::string_view text = facts_.main().text();
    const bool is_closed = span.end > 0 && span.end <= text.size() && text[span.end - 1] == '}';
    const bool is_top = span == facts_.files.back().program.span;
    symbol.of_file = is_top;
    symbol.visible = {from, is_closed && !is_top ? span.end - 1 : span.end, facts_.main_source()};
    symbol.scope = span.end - span.begin;
  }

  // ---- entries of a session before this one
  void add_earlier() {
    if (facts_.options.after == nullptr) return;
    const KeptFile& kept = facts_.options.after->compiled().entry.kept->main();
    kept.names.for_each([&](const KeptFile::Bucket& bucket) {
      for (const KeptName& name : bucket) add_earlier(name);
    });
  }

  // Adds a name of an earlier entry. It is visible everywhere, but hidden by declarations of the
  // text itself.
  void add_earlier(const KeptName& kept) {
    const Span text = facts_.files.back().program.span;
    Symbol out{.name = kept.name, .declared = kept.declared, .is_typed = true, .of_file = true};
    out.visible = {0, std::max(text.end, 1U), text.source};
    out.scope = text.end + 1;
    if (kept.variable != nullptr) out.type = kept.variable->type;
    if (kept.import != nullptr) out.kind = NameKind::kModule;
    if (kept.function != nullptr) {
      const ast::FunctionStmt& node = *kept.function->node;
      const std::uint32_t end =
          node.body != nullptr ? node.body->span.begin : node.value->span.begin;
      out.kind = NameKind::kFunction;
      out.header = without_tail(slice(node.span.begin, end, node.span.source));
      out.doc = node.doc;
      out.function = &node;
    }
    if (kept.type != nullptr) add_type(kept, out);
    facts_.names.symbols.push_back(out);
  }

  void add_type(const KeptName& kept, Symbol& out) const {
    if (kept.type->is(Kind::kEnum)) {
      out.kind = NameKind::kEnum;
      out.values = kept.type;
      return;
    }
    const KeptType* known =
        facts_.options.after->compiled().entry.kept->types.find(key_of(kept.type->record));
    out.kind = NameKind::kStruct;
    if (known == nullptr) return;
    out.structure = known->node;
    out.header = head(*known->node, known->node->name, 0);
  }

  void finish_symbols() {
    std::erase_if(facts_.names.symbols, [](const Symbol& s) { return s.name.empty(); });
    const auto is_known = [](const Symbol& s) {
      return s.type != nullptr && !s.type->is(Kind::kAny);
    };
    std::ranges::stable_sort(facts_.names.symbols, [&](const Symbol& a, const Symbol& b) {
      return std::tuple(position(a.declared), !is_known(a)) <
             std::tuple(position(b.declared), !is_known(b));
    });
    keep_first(facts_.names.symbols, &Symbol::declared);
  }

  // ---- names
  // The last bytes of a span if they are the name; otherwise the name is not in the text there.
  [[nodiscard]] std::optional<Span> written(Span span, std::string_view name) const {
    const std::string_view text = facts_.compiled.sources->slice(span);
    if (name.empty() || !text.ends_with(name)) return std::nullopt;
    if (text.size() > name.size() && text[text.size() - name.size() - 1] != '.')
      return std::nullopt;
    return Span{span.end - static_cast<std::uint32_t>(name.size()), span.end, span.source};
  }

  void add_references() {
    const auto add = [this](Span name, const Symbol& symbol) {
      facts_.names.references.push_back(
          {name, static_cast<std::uint32_t>(&symbol - facts_.names.symbols.data())});
    };
    for (const Symbol& symbol : facts_.names.symbols) {
      if (const auto name = written(symbol.declared, symbol.name)) add(*name, symbol);
    }
    for (const Learnt::Use& use : facts_.learnt.uses()) {
      const Symbol* symbol =
          use.declaration.empty() ? nullptr : facts_.declared_at(use.declaration);
      if (symbol == nullptr) continue;
      if (const auto name = written(use.name, symbol->name)) add(*name, *symbol);
    }
    std::ranges::stable_sort(facts_.names.references, {},
                             [](const Reference& r) { return position(r.name); });
    keep_first(facts_.names.references, &Reference::name);
    facts_.names.by_symbol = facts_.names.references;
    std::ranges::stable_sort(facts_.names.by_symbol, {}, &Reference::symbol);
  }

  void add_natives() {
    for (Learnt::NativeUse use : facts_.learnt.natives()) {
      if (use.name.source != facts_.main_source()) continue;
      std::string_view name = use.function->name;
      name.remove_prefix(name.rfind('.') + 1);
      std::string parameter;
      if (use.parameter >= 0) {
        const Signature& signature = facts_.signed_->signatures.of(*use.function);
        parameter = signature.parameters[static_cast<std::size_t>(use.parameter)].name;
        name = parameter;
      }
      const auto at = written(use.name, name);
      if (!at) continue;
      use.name = *at;
      facts_.natives.push_back(use);
    }
    std::ranges::stable_sort(facts_.natives, {}, [](const auto& n) { return position(n.name); });
    keep_first(facts_.natives, &Learnt::NativeUse::name);
  }

  // ---- values
  void add_values() {
    facts_.values.type_of.reserve(facts_.learnt.values().size());
    for (const Learnt::Value& value : facts_.learnt.values()) {
      const auto [known, is_new] = facts_.values.type_of.try_emplace(value.written, value.type);
      if (!is_new && known->second->is(Kind::kAny)) known->second = value.type;
      if (is_new && value.written->span.source == facts_.main_source() &&
          !value.written->span.empty())
        facts_.values.spans.push_back({value.written->span, nullptr, value.written});
    }
    for (TypedSpan& value : facts_.values.spans) value.type = facts_.values.type_of[value.written];
    std::ranges::stable_sort(facts_.values.spans, {}, [](const TypedSpan& v) {
      return std::tuple(v.span.begin, 0xFFFFFFFFU - v.span.end);
    });
    std::vector<Span> spans;
    spans.reserve(facts_.values.spans.size());
    for (const TypedSpan& value : facts_.values.spans) spans.push_back(value.span);
    facts_.values.innermost = InnermostSpans(spans);
  }

  struct Declared {
    Span name;
    std::uint32_t from;
    std::string_view doc;
    bool has_hint;  // a hint with its type is useful
  };

  Facts& facts_;
  bool main_ = false;
  std::vector<Span> scopes_;  // of the main text
  std::vector<Declared> declared_;
};

}  // namespace

void index_facts(Facts& facts) {
  if (!facts.files.empty()) Indexer(facts).run();
}

}  // namespace armlet::lang
