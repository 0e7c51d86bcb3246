// Maps: entries one after the other, found by looking at each.

#include <algorithm>

#include "evaluator.hpp"
#include "show.hpp"

namespace armlet::oracle {

using namespace lang::hir;

std::size_t Map::find(const Value& key) const {
  std::size_t i = 0;
  while (i < keys.size() && !equal(keys[i], key)) ++i;
  return i;
}

Value Evaluator::of_map(const Expr& e) {
  switch (e.kind) {
    case ExprKind::kMap:
      return map(e.as<MapExpr>());
    case ExprKind::kEntry:
      return entry(e.as<EntryExpr>());
    case ExprKind::kMapQuery:
      return map_query(e.as<MapQueryExpr>());
    default:
      throw std::logic_error("the oracle has no such expression: " + text(e.span));
  }
}

Value Evaluator::map(const MapExpr& e) {
  Map out;
  for (std::size_t i = 0; i < e.keys.size(); ++i) {
    Value key = evaluate(*e.keys[i]);
    Value value = evaluate(*e.values[i]);
    if (out.find(key) < out.keys.size())
      fail("R0639", e.keys[i]->span, {key_text(key, *e.type->key)});
    out.keys.push_back(std::move(key));
    out.values.push_back(std::move(value));
  }
  return {std::move(out)};
}

Value Evaluator::entry(const EntryExpr& e) {
  const Value map = evaluate(*e.object);
  const Value key = evaluate(*e.key);
  const Value otherwise = e.otherwise == nullptr ? Value{} : evaluate(*e.otherwise);
  const std::size_t at = map.map().find(key);
  if (at < map.map().keys.size()) return map.map().values[at];
  if (e.otherwise == nullptr) fail_key(key, *e.object->type, e.span);
  return otherwise;
}

Value Evaluator::map_query(const MapQueryExpr& e) {
  const Value map = evaluate(*e.object);
  switch (e.question) {
    case MapQuestion::kKeys:
      return {List{map.map().keys}};
    case MapQuestion::kValues:
      return {List{map.map().values}};
    case MapQuestion::kHas:
      break;
  }
  return {map.map().find(evaluate(*e.key)) < map.map().keys.size()};
}

Value Evaluator::remove_key(const MutateExpr& e) {
  check_set(*e.place.variable, e.span);
  const Indices where = indices(e.place);
  const Value key = evaluate(*e.index);
  Map& map = walk(e.place, where).map();
  const std::size_t at = map.find(key);
  if (at == map.keys.size()) fail_key(key, *e.place.type, e.span);
  Value removed = std::move(map.values[at]);
  map.keys.erase(map.keys.begin() + static_cast<std::ptrdiff_t>(at));
  map.values.erase(map.values.begin() + static_cast<std::ptrdiff_t>(at));
  return removed;
}

// makes: a new entry if there is none.
Value& Evaluator::step_to_entry(Value& map, const Step& step, const Value& key, bool makes) const {
  Map& entries = map.map();
  const std::size_t at = entries.find(key);
  if (at == entries.keys.size()) {
    if (!makes) fail_key(key, *step.map, step.span);
    entries.keys.push_back(key);
    entries.values.emplace_back();
  }
  return entries.values[at];
}

// Long texts are cut where a character begins.
std::string Evaluator::key_text(const Value& key, const Type& type) {
  constexpr std::size_t kLongest = 40;
  const std::string text = show(key, type, {});
  if (!type.is(Kind::kText)) return text;
  std::size_t end = std::min(text.size(), kLongest);
  const auto is_inside = [&] { return (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U; };
  while (end < text.size() && end > 0 && is_inside()) --end;
  return '"' + text.substr(0, end) + (end < text.size() ? "...\"" : "\"");
}

void Evaluator::fail_key(const Value& key, const Type& map, Span where) const {
  fail("R0638", where, {key_text(key, *map.key)});
}

}  // namespace armlet::oracle
