#include "check/blocks/block_declarations.hpp"

#include <algorithm>

#include "check/blocks/named_rows.hpp"
#include "check/calls/calls.hpp"
#include "check/library/native_calls.hpp"
#include "check/names/imports.hpp"
#include "check/names/unknown_names.hpp"
#include "check/names/variables.hpp"
#include "check/state/checker.hpp"

namespace armlet::lang {

namespace {

hir::Expr* block_value(Checker& checker, const ast::ObjectStmt& stmt, const Type* type,
                       std::vector<hir::Stmt*>& out);
std::vector<Argument> block_rows(Checker& checker, const ast::ObjectStmt& stmt);
void add_missing_rows(Checker& checker, const NativeFunction& maker, Span span,
                      std::vector<Argument>& arguments);
hir::Expr* block_row(Checker& checker, const ast::ObjectStmt& stmt, const ast::BlockItem& item);

}  // namespace

hir::Stmt* check_object(Checker& checker, const ast::ObjectStmt& stmt) {
  const Type* type = checker.resolve(*stmt.type);
  const bool top_level = checker.scopes.at_top_level();
  Use used;
  Use& use_before = checker.scopes.use();
  if (top_level) checker.scopes.collect_in(used);
  std::vector<hir::Stmt*> out;
  hir::Expr* value =
      type->is(Kind::kAny) ? checker.failed(stmt.span) : block_value(checker, stmt, type, out);
  checker.scopes.collect_in(use_before);
  const bool fresh = is_free(checker, stmt.name);
  if (fresh && top_level) refuse_second_owner(checker, stmt, type);
  hir::Variable* variable = new_variable(checker, stmt.name.text, type, stmt.name.span);
  variable->fixed = true;
  variable->init = value;
  if (fresh) checker.scopes.add(variable, Declared::kBlock, stmt.type->span)->used = true;
  auto* init = checker.make<hir::InitStmt>(hir::StmtKind::kInit, stmt.span, variable, value);
  if (top_level) {
    checker.shared.top_level.add(variable, init, std::move(used));
  }
  if (out.empty()) return init;
  out.push_back(init);
  return checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.span, checker.seq(out));
}

hir::Expr* unknown_row(Checker& checker, const ast::ObjectStmt& stmt, const ast::BlockItem& item) {
  const std::string type = checker.text_of(stmt.type->span);
  const std::string part = type + '.' + std::string(item.name.text);
  const bool wrong_part = !checker.registry.is_namespace(part);
  const std::string prefix = wrong_part ? type + '.' : part + '.';
  std::vector<std::string_view> known;
  for (std::string_view name : checker.registry.public_names()) {
    if (!name.starts_with(prefix)) continue;
    name.remove_prefix(prefix.size());
    if (wrong_part == (name.find('.') != std::string_view::npos))
      known.push_back(name.substr(0, name.find('.')));
  }
  const ast::Name& word = wrong_part ? item.name : item.constructor;
  Diagnostic diagnostic = make_diagnostic("E0201", word.span, {std::string(word.text)});
  known.erase(std::unique(known.begin(), known.end()), known.end());
  if (wrong_part && !known.empty()) {
    diagnostic.why = "the rows of a `" + type + "` block are ";
    for (std::size_t i = 0; i < known.size(); ++i)
      diagnostic.why += (i == 0                 ? ""
                         : i + 1 < known.size() ? ", "
                                                : " and ") +
                        ('`' + std::string(known[i]) + '`');
  }
  diagnostic.fix = did_you_mean(checker, word.text, word.span, known);
  checker.report(std::move(diagnostic));
  return checker.failed(item.span);
}

namespace {

hir::Expr* block_value(Checker& checker, const ast::ObjectStmt& stmt, const Type* type,
                       std::vector<hir::Stmt*>& out) {
  const std::string_view type_text = checker.arena.copy(type_name(type));
  const std::string_view maker = checker.arena.copy(std::string(type_text) + "{}");
  const auto makers = checker.registry.functions(maker);
  const bool is_struct = type->is(Kind::kRecord) && checker.shared.structs.find(type) != nullptr;
  if (!is_struct && makers.empty()) {
    checker.report(make_diagnostic("E0217", stmt.type->span,
                                   {std::string(type_text), "a type without a block form"}));
    return checker.failed(stmt.span);
  }
  const bool names_rows = checker.registry.has_named_rows(type_text);
  if (names_rows && !may_have_named_rows(checker, stmt)) return checker.failed(stmt.span);
  std::vector<Argument> arguments =
      names_rows ? named_rows(checker, stmt, out) : block_rows(checker, stmt);
  for (const ast::BlockItem& item : stmt.items) {
    if (item.is_row) continue;
    Argument argument{.name = item.name.text, .name_span = item.name.span, .written = item.value};
    if (!waits(checker, *item.value)) {
      const Type* hint = list_hint(checker, maker, {item.name, item.value, item.span}, 0);
      argument.value = checker.check_value(*item.value, hint);
    }
    arguments.push_back(argument);
  }
  if (is_struct) {
    return construct(checker, *checker.shared.structs.find(type), stmt.name.span, stmt.span,
                     std::move(arguments));
  }
  const std::string_view name = checker.arena.copy(stmt.name.text);
  arguments.push_back({.name = "name",
                       .name_span = stmt.name.span,
                       .value = checker.make<hir::TextExpr>(
                           hir::ExprKind::kText, checker.types.text(), stmt.name.span, name)});
  add_missing_rows(checker, *makers[0], stmt.name.span, arguments);
  return call_native(checker, type_text, makers, stmt.name.span, stmt.span, std::move(arguments));
}

// The rows of a block, as one list argument for each kind of row. The argument has the name of the
// kind.
std::vector<Argument> block_rows(Checker& checker, const ast::ObjectStmt& stmt) {
  std::vector<std::pair<ast::Name, std::vector<hir::Expr*>>> parts;
  std::unordered_map<std::string_view, std::size_t> places;  // of the kinds of rows, by name
  for (const ast::BlockItem& item : stmt.items) {
    if (!item.is_row) continue;
    hir::Expr* row = block_row(checker, stmt, item);
    const auto [place, is_new] = places.try_emplace(item.name.text, parts.size());
    if (is_new) parts.push_back({item.name, {}});
    parts[place->second].second.push_back(row);
  }
  std::vector<Argument> out;
  for (const auto& [name, rows] : parts) {
    const auto bad =
        std::ranges::find_if(rows, [](const hir::Expr* row) { return row->type->is(Kind::kAny); });
    hir::Expr* list =
        bad != rows.end()
            ? *bad
            : checker.make<hir::ListExpr>(hir::ExprKind::kList, checker.types.list(rows[0]->type),
                                          name.span, checker.seq(rows));
    out.push_back({.name = name.text, .name_span = name.span, .value = list});
  }
  return out;
}

// Adds an empty list for a kind of row that does not occur. The rule of the host decides whether it
// may be missing.
void add_missing_rows(Checker& checker, const NativeFunction& maker, Span span,
                      std::vector<Argument>& arguments) {
  for (const Parameter& parameter : checker.shared.signatures.of(maker).parameters) {
    const Type* list = instantiate(parameter.type, {}, checker.types);
    const auto given = [&](const Argument& argument) { return argument.name == parameter.name; };
    if (list == nullptr || !list->is(Kind::kList) || parameter.may_be_left_out() ||
        std::ranges::any_of(arguments, given)) {
      continue;
    }
    arguments.push_back({.name = checker.arena.copy(parameter.name),
                         .name_span = span,
                         .value = checker.make<hir::ListExpr>(hir::ExprKind::kList, list, span,
                                                              hir::Seq<hir::Expr*>{})});
  }
}

// Checks a row such as phase wound(...), a call of the function "motor.phase.wound".
hir::Expr* block_row(Checker& checker, const ast::ObjectStmt& stmt, const ast::BlockItem& item) {
  const std::string part = checker.text_of(stmt.type->span) + '.' + std::string(item.name.text);
  const std::string full = part + '.' + std::string(item.constructor.text);
  const auto makers = checker.registry.functions(full);
  if (makers.empty()) return unknown_row(checker, stmt, item);
  const std::string_view name = checker.arena.copy(full);
  return call_native(checker, item.constructor.text, makers, item.constructor.span, item.span,
                     arguments_of(checker, item.args, name));
}

}  // namespace

}  // namespace armlet::lang
