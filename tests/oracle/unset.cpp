// Elements without a value: looked for in whole trees, whenever a value is used.

#include "evaluator.hpp"
#include "show.hpp"

namespace armlet::oracle {

using namespace lang::hir;

namespace {

// The path to the first element without a value; false: there is none. What a list has no value
// for is absent; nothing else is.
bool find_unset(const Value& value, const Type& type, bool deep, std::string& path) {
  const std::string before = path;
  if (std::holds_alternative<List>(value.is)) {
    const auto& items = value.list().items;
    for (std::size_t i = 0; i < items.size(); ++i) {
      path = before + '[' + std::to_string(i) + ']';
      if (items[i].absent() || (deep && find_unset(items[i], *type.element, true, path)))
        return true;
    }
  } else if (std::holds_alternative<Map>(value.is)) {
    const Map& map = value.map();
    for (std::size_t i = 0; i < map.keys.size(); ++i) {
      const bool is_text = type.key->is(Kind::kText);
      const std::string key = show(map.keys[i], *type.key, {});
      path = before + (is_text ? "[\"" + key + "\"]" : '[' + key + ']');
      if (find_unset(map.values[i], *type.element, true, path)) return true;
    }
  } else if (std::holds_alternative<Record>(value.is)) {
    const auto& fields = type.record->fields;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      path = before + '.' + fields[i].name;
      if (find_unset(value.record().fields[i], *fields[i].type, true, path)) return true;
    }
  }
  path = before;
  return false;
}

}  // namespace

std::size_t Evaluator::last_bracket(const std::string& text) {
  std::size_t at = text.size();
  for (int open = 0; at-- > 0;) {
    if (text[at] == ']') ++open;
    if (text[at] == '[' && --open == 0) break;
  }
  return at;
}

std::string Evaluator::short_text(Span span) const {
  const std::string name = text(span);
  return name.empty() || name.size() > 60 || name.find('\n') != std::string::npos ? "..." : name;
}

void Evaluator::fail_unset(std::int64_t index, Span list, Span where) const {
  fail("R0623", where, {short_text(list) + '[' + std::to_string(index) + ']'});
}

void Evaluator::check_whole(const Value& value, const Type& type, Span where, bool deep) const {
  std::string path;
  if (find_unset(value, type, deep, path)) fail("R0623", where, {short_text(where) + path});
}

const Value& Evaluator::set_item(const Value& list, std::size_t index, Span where) const {
  const Value& item = list.list().items[index];
  if (item.absent()) fail_unset(static_cast<std::int64_t>(index), where, where);
  return item;
}

}  // namespace armlet::oracle
