// Checks types, literals and entries of maps.

#include "check/types/maps.hpp"

#include <unordered_map>

#include "check/types/types.hpp"

namespace armlet::lang {
namespace {

bool can_be_key(const Type* type) {
  return type->is(Kind::kText) || type->is(Kind::kInt) || type->is(Kind::kEnum);
}

// Reports int[n] xs: the size of a list belongs after `new`.
bool refuse_size(Checker& checker, const ast::TypeExpr& written) {
  const ast::TypeExpr& key = *written.key;
  FunctionContext* where = nullptr;
  if (key.path.size() != 1 || type_called(checker, key.path[0].text) != nullptr) return false;
  if (checker.scopes.find(key.path[0].text, where) == nullptr) return false;
  const std::string name(key.path[0].text);
  Diagnostic diagnostic = make_diagnostic("E0338", key.span, {'`' + name + "`, a variable"});
  diagnostic.why = "the size of a list is no part of its type";
  const std::string element = checker.text_of(written.element->span);
  diagnostic.fix = Fix{.text = "write " + element + "[] ... = new " + element + '[' + name + ']'};
  checker.report(std::move(diagnostic));
  return true;
}

// The text of a constant key, to find repeated keys; empty if it is not constant.
std::string known_key(const Checker& checker, const hir::Expr& key) {
  if (key.kind == hir::ExprKind::kEnum) return std::to_string(key.as<hir::IntExpr>().value);
  const auto constant = checker.shared.constants.of(key);
  if (!constant) return {};
  if (constant->kind == Constant::Kind::kText) return '"' + constant->text + '"';
  if (constant->kind == Constant::Kind::kInt) return std::to_string(constant->integer);
  return {};
}

bool refuse_key_twice(Checker& checker, const std::vector<hir::Expr*>& keys) {
  std::unordered_map<std::string, Span> seen;
  for (const hir::Expr* key : keys) {
    const std::string known = known_key(checker, *key);
    if (known.empty()) continue;
    const auto [first, is_new] = seen.emplace(known, key->span);
    if (is_new) continue;
    const bool is_value = key->kind == hir::ExprKind::kEnum;
    Diagnostic diagnostic =
        make_diagnostic("E0339", key->span, {is_value ? checker.text_of(key->span) : known});
    diagnostic.related.push_back({first->second, "it stands here already"});
    checker.report(std::move(diagnostic));
    return true;
  }
  return false;
}

// Reports {bolt: 3}: a text as a key needs quotes.
bool refuse_bare_name(Checker& checker, const ast::Expr& written) {
  if (written.kind != ast::ExprKind::kName) return false;
  const std::string_view name = written.as<ast::NameExpr>().name;
  FunctionContext* where = nullptr;
  if (checker.scopes.find(name, where) != nullptr || checker.names.find_function(name) != nullptr ||
      !checker.registry.functions(name).empty() || checker.registry.constant(name) != nullptr)
    return false;
  if (!checker.messages.is_news(name)) return true;
  const std::string text = '"' + std::string(name) + '"';
  Diagnostic diagnostic = make_diagnostic("E0201", written.span, {std::string(name)});
  diagnostic.why = "a key that is a text stands in quotes";
  diagnostic.fix = Fix{.text = "write " + text, .edits = {{written.span, text}}};
  checker.report(std::move(diagnostic));
  return true;
}

// The keys of a literal, which all have the expected type or that of the first key; `type` is null
// after a message.
std::vector<hir::Expr*> keys_of(Checker& checker, const ast::MapExpr& map, const Type*& type) {
  std::vector<hir::Expr*> keys;
  for (const ast::Expr* written : map.keys) {
    if ((type == nullptr || type->is(Kind::kText)) && refuse_bare_name(checker, *written)) {
      type = nullptr;
      return {};
    }
    hir::Expr* key = checker.check_value(*written, type);
    const Type* found = key->type;
    if (type == nullptr && !found->is(Kind::kAny) && !can_be_key(found)) {
      checker.report(make_diagnostic("E0338", key->span, {type_phrase(found)}));
      found = checker.types.any();
    }
    if (type == nullptr) type = found;
    if (!found->is(Kind::kAny)) key = checker.require(key, {.type = type, .name = "key"});
    if (key->type->is(Kind::kAny)) {
      type = nullptr;
      return {};
    }
    keys.push_back(key);
  }
  if (refuse_key_twice(checker, keys)) type = nullptr;
  return keys;
}

// The type of the values of a literal without an expected type: the one that fits all of them; null
// after a message.
const Type* type_of_values(Checker& checker, std::vector<hir::Expr*>& values) {
  hir::Expr* widest = values.front();
  for (hir::Expr* value : values) {
    const Type* type = common_type(checker, *widest, *value);
    if (type == nullptr) {
      Diagnostic diagnostic = make_diagnostic(
          "E0330", value->span, {type_phrase(widest->type), type_phrase(value->type)});
      diagnostic.message.replace(diagnostic.message.find("list"), 4, "map");
      checker.report(std::move(diagnostic));
      return nullptr;
    }
    if (type != widest->type) widest = value;
  }
  for (hir::Expr*& value : values) {
    if (hir::Expr* same = checker.convert(value, widest->type)) value = same;
  }
  return widest->type;
}

hir::Expr* key_value(Checker& checker, const ast::Expr& written, const Type* map) {
  return checker.check_as(written, {.type = map->key, .name = "key"});
}

}  // namespace

const Type* map_type(Checker& checker, const ast::TypeExpr& written) {
  const Type* element = checker.resolve(*written.element);
  if (refuse_size(checker, written)) return checker.types.any();
  const Type* key = checker.resolve(*written.key);
  if (key->is(Kind::kAny) || element->is(Kind::kAny)) return checker.types.any();
  if (can_be_key(key)) return checker.types.map(key, element);
  checker.report(make_diagnostic("E0338", written.key->span, {type_phrase(key)}));
  return checker.types.any();
}

hir::Expr* empty_map(Checker& checker, const Type* type, Span span) {
  return checker.make<hir::MapExpr>(hir::ExprKind::kMap, type, span, hir::Seq<hir::Expr*>{},
                                    hir::Seq<hir::Expr*>{});
}

hir::Expr* check_map(Checker& checker, const ast::MapExpr& map, const Type* expected) {
  const Type* const any = checker.types.any();
  const Type* wanted = expected != nullptr && expected->is(Kind::kMap) ? expected : nullptr;
  if (map.keys.empty())
    return empty_map(checker, wanted != nullptr ? wanted : checker.types.map(any, any), map.span);
  const Type* key = wanted != nullptr ? wanted->key : nullptr;
  const std::vector<hir::Expr*> keys = keys_of(checker, map, key);
  if (key == nullptr) return checker.failed(map.span);
  const Type* element = wanted != nullptr ? wanted->element : nullptr;
  std::vector<hir::Expr*> values;
  for (const ast::Expr* written : map.values) {
    hir::Expr* value = checker.check_value(*written, element);
    if (element != nullptr && !value->type->is(Kind::kAny))
      value = checker.require(value, {.role = Target::Role::kElement, .type = element});
    if (value->type->is(Kind::kAny)) return checker.failed(map.span);
    values.push_back(value);
  }
  if (element == nullptr) element = type_of_values(checker, values);
  if (element == nullptr) return checker.failed(map.span);
  return checker.make<hir::MapExpr>(hir::ExprKind::kMap, checker.types.map(key, element), map.span,
                                    checker.seq(keys), checker.seq(values));
}

hir::Expr* convert_map(Checker& checker, const hir::MapExpr& map, const Type* type) {
  std::vector<hir::Expr*> keys;
  std::vector<hir::Expr*> values;
  for (std::size_t i = 0; i < map.keys.size(); ++i) {
    keys.push_back(checker.convert(map.keys[i], type->key));
    values.push_back(checker.convert(map.values[i], type->element));
    if (keys.back() == nullptr || values.back() == nullptr) return nullptr;
  }
  return checker.make<hir::MapExpr>(hir::ExprKind::kMap, type, map.span, checker.seq(keys),
                                    checker.seq(values));
}

hir::Expr* entry_of(Checker& checker, const ast::IndexExpr& index, hir::Expr* map) {
  const ast::IndexItem& item = index.items[0];
  if (item.is_range) {
    Diagnostic diagnostic = make_diagnostic("E0318", index.span, {"a map"});
    diagnostic.message = "a map has no part from one key to another";
    checker.report(std::move(diagnostic));
    return checker.failed(index.span);
  }
  if (map->type->element->is(Kind::kAny)) {
    checker.report(make_diagnostic("E0323", index.object->span, {"this empty map"}));
    return checker.failed(index.span);
  }
  hir::Expr* key = key_value(checker, *item.first, map->type);
  if (key->type->is(Kind::kAny)) return checker.failed(index.span);
  return checker.make<hir::EntryExpr>(hir::ExprKind::kEntry, map->type->element, index.span, map,
                                      key, nullptr);
}

std::optional<hir::Step> entry_step(Checker& checker, const ast::IndexExpr& index,
                                    const Type* map) {
  hir::Step step{};
  step.span = index.span;
  step.map = map;
  step.type = map->element;
  step.index = key_value(checker, *index.items[0].first, map);
  if (step.index->type->is(Kind::kAny)) return std::nullopt;
  return step;
}

hir::Expr* parts_of_map(Checker& checker, hir::MapQuestion question, hir::Expr* map, Span span) {
  const Type* part = question == hir::MapQuestion::kKeys ? map->type->key : map->type->element;
  return checker.make<hir::MapQueryExpr>(hir::ExprKind::kMapQuery, checker.types.list(part), span,
                                         question, map, nullptr);
}

}  // namespace armlet::lang
