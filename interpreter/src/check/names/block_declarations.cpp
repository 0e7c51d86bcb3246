// T name { field: value; row constructor(...) }: for structs, and for host types with a function
// "T{}".

#include <algorithm>

#include "check/checker.hpp"
#include "check/names/imports.hpp"

namespace armlet::lang {

hir::Stmt* Checker::check_object(const ast::ObjectStmt& stmt) {
  const Type* type = resolve(*stmt.type);
  const bool top_level = here_ == &main_ && main_.blocks.size() == 1;
  Use used;
  Use* const use_before = use_;
  if (top_level) use_ = &used;
  hir::Expr* value = type->is(Kind::kAny) ? failed(stmt.span) : block_value(stmt, type);
  use_ = use_before;
  const bool fresh = is_free(stmt.name);
  if (fresh && top_level) refuse_second_owner(*this, stmt, type);
  hir::Variable* variable = new_variable(stmt.name.text, type, stmt.name.span);
  variable->fixed = true;
  variable->init = value;
  if (fresh) add_local(variable, Declared::kBlock, stmt.type->span)->used = true;
  auto* init = make<hir::InitStmt>(hir::StmtKind::kInit, stmt.span, variable, value);
  if (top_level) {
    top_level_.emplace_back(variable, init);
    init_uses_[variable] = std::move(used);
  }
  return init;
}

hir::Expr* Checker::block_value(const ast::ObjectStmt& stmt, const Type* type) {
  const std::string_view type_text = arena_.copy(type_name(type));
  const std::string_view maker = arena_.copy(std::string(type_text) + "{}");
  const auto makers = registry_.functions(maker);
  const bool is_struct = type->is(Kind::kRecord) && structs_.contains(type->record);
  if (!is_struct && makers.empty()) {
    report(make_diagnostic("E0217", stmt.type->span,
                           {std::string(type_text), "a type without a block form"}));
    return failed(stmt.span);
  }
  std::vector<Argument> arguments = block_rows(stmt);
  for (const ast::BlockItem& item : stmt.items) {
    if (item.is_row) continue;
    Argument argument{.name = item.name.text, .name_span = item.name.span, .written = item.value};
    if (!waits(*item.value)) {
      const Type* hint = list_hint(maker, {item.name, item.value, item.span}, 0);
      argument.value = check_value(*item.value, hint);
    }
    arguments.push_back(argument);
  }
  if (is_struct) {
    return construct(structs_[type->record], stmt.name.span, stmt.span, std::move(arguments));
  }
  const std::string_view name = arena_.copy(stmt.name.text);
  arguments.push_back(
      {.name = "name",
       .name_span = stmt.name.span,
       .value = make<hir::TextExpr>(hir::ExprKind::kText, types_.text(), stmt.name.span, name)});
  add_missing_rows(*makers[0], stmt.name.span, arguments);
  return call_native(type_text, makers, stmt.name.span, stmt.span, std::move(arguments));
}

// The rows of each part as one list, named like the part.
std::vector<Argument> Checker::block_rows(const ast::ObjectStmt& stmt) {
  std::vector<std::pair<ast::Name, std::vector<hir::Expr*>>> parts;
  std::unordered_map<std::string_view, std::size_t> places;  // of the parts, by name
  for (const ast::BlockItem& item : stmt.items) {
    if (!item.is_row) continue;
    hir::Expr* row = block_row(stmt, item);
    const auto [place, is_new] = places.try_emplace(item.name.text, parts.size());
    if (is_new) parts.push_back({item.name, {}});
    parts[place->second].second.push_back(row);
  }
  std::vector<Argument> out;
  for (const auto& [name, rows] : parts) {
    const auto bad =
        std::ranges::find_if(rows, [](const hir::Expr* row) { return row->type->is(Kind::kAny); });
    hir::Expr* list = bad != rows.end()
                          ? *bad
                          : make<hir::ListExpr>(hir::ExprKind::kList, types_.list(rows[0]->type),
                                                name.span, seq(rows));
    out.push_back({.name = name.text, .name_span = name.span, .value = list});
  }
  return out;
}

// A part that repeats may be missing altogether: the rule of the host says whether that is right.
void Checker::add_missing_rows(const NativeFunction& maker, Span span,
                               std::vector<Argument>& arguments) {
  for (const Parameter& parameter : signature_of(maker).parameters) {
    const Type* list = instantiate(parameter.type, {}, types_);
    const auto given = [&](const Argument& argument) { return argument.name == parameter.name; };
    if (list == nullptr || !list->is(Kind::kList) || parameter.may_be_left_out() ||
        std::ranges::any_of(arguments, given)) {
      continue;
    }
    arguments.push_back(
        {.name = arena_.copy(parameter.name),
         .name_span = span,
         .value = make<hir::ListExpr>(hir::ExprKind::kList, list, span, hir::Seq<hir::Expr*>{})});
  }
}

// phase wound(...): a call of "motor.phase.wound".
hir::Expr* Checker::block_row(const ast::ObjectStmt& stmt, const ast::BlockItem& item) {
  const std::string part = text_of(stmt.type->span) + '.' + std::string(item.name.text);
  const std::string full = part + '.' + std::string(item.constructor.text);
  const auto makers = registry_.functions(full);
  if (makers.empty()) {
    std::vector<std::string_view> known;
    const bool wrong_part = !registry_.is_namespace(part);
    const std::string prefix = wrong_part ? text_of(stmt.type->span) + '.' : part + '.';
    for (std::string_view name : registry_.public_names()) {
      if (!name.starts_with(prefix)) continue;
      name.remove_prefix(prefix.size());
      if (wrong_part == (name.find('.') != std::string_view::npos))
        known.push_back(name.substr(0, name.find('.')));
    }
    const ast::Name& word = wrong_part ? item.name : item.constructor;
    Diagnostic diagnostic = make_diagnostic("E0201", word.span, {std::string(word.text)});
    diagnostic.fix = did_you_mean(word.text, word.span, known);
    report(std::move(diagnostic));
    return failed(item.span);
  }
  const std::string_view name = arena_.copy(full);
  return call_native(item.constructor.text, makers, item.constructor.span, item.span,
                     arguments_of(item.args, name));
}

}  // namespace armlet::lang
