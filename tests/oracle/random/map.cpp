// Maps: literals, entries that are there and others, entries that are stored and removed while
// something else reads them.

#include "random/program.hpp"

namespace armlet::oracle {

const Ty* RandomProgram::map_of(const Ty* key, const Ty* element) {
  for (const Ty& type : types_) {
    if (type.is(Sort::kMap) && type.element == element && type.key == key) return &type;
  }
  types_.push_back({Sort::kMap, element->name + "[" + key->name + "]", element});
  types_.back().key = key;
  return &types_.back();
}

const Ty* RandomProgram::some_map() {
  const Ty* key = one_in(3) ? int_ : !enums_.empty() && one_in(4) ? one_of(enums_) : text_;
  switch (below(8)) {
    case 0:
      return map_of(key, list_of(int_));
    case 1:
      return map_of(key, real_);
    case 2:
      return map_of(key, text_);
    case 3:
      return map_of(key, map_of(text_, int_));
    case 4:
      if (!structs_.empty()) return map_of(key, structs_[0].type);
      [[fallthrough]];
    default:
      return map_of(key, int_);
  }
}

// Keys of literals, all different.
std::string RandomProgram::plain_key(const Ty* key, std::size_t i) {
  static const std::vector<std::string> kWords = {"a", "b", "h\u00e9llo", "Zz top", "c"};
  static const std::vector<std::string> kNumbers = {"0", "1", "2", "-1", "4611686018427387904"};
  if (key->is(Sort::kInt)) return kNumbers[i % kNumbers.size()];
  if (key->is(Sort::kEnum)) return key->name + "." + enum_values_[key->id][i];
  const std::string quote = in_format_ ? "'" : "\"";
  return quote + kWords[i % kWords.size()] + quote;
}

// Mostly one that exists.
std::string RandomProgram::key_of(const Ty* map, int depth) {
  if (one_in(8)) return expr(map->key, depth);
  if (map->key->is(Sort::kInt) && one_in(3)) return "(counter % 3)";
  return plain_key(map->key, below(2));
}

std::string RandomProgram::map_literal(const Ty* type, int depth) {
  std::size_t most = 4;
  if (type->key->is(Sort::kEnum)) most = enum_values_[type->key->id].size();
  const std::size_t count = one_in(8) && depth > 0 ? 0 : 1 + below(most);
  if (count == 0)
    return "(" + truth(0) + " ? [:] : [" + plain_key(type->key, 0) + ": " + leaf(type->element) +
           "])";
  std::string out;
  for (std::size_t i = 0; i < count; ++i) {
    // Whether two computed keys are the same is found out while running.
    const bool is_computed = type->key->is(Sort::kInt) && one_in(6);
    const std::string key = is_computed ? "(pile.length - 2)" : plain_key(type->key, i);
    out += (i == 0 ? "" : ", ") + key + ": " +
           (depth > 0 ? expr(type->element, depth - 1) : leaf(type->element));
  }
  return "[" + out + "]";
}

const RandomProgram::Var* RandomProgram::find_map(const Ty* key, const Ty* element,
                                                  bool to_change) {
  std::vector<const Var*> found;
  for (std::size_t i = 0; i < vars_.size(); ++i) {
    const Ty* type = vars_[i].type;
    const bool fits = type->is(Sort::kMap) && (key == nullptr || type->key == key) &&
                      (element == nullptr || type->element == element);
    if (fits && (!to_change || (vars_[i].can_change && i >= first_changeable_)))
      found.push_back(&vars_[i]);
  }
  return found.empty() ? nullptr : one_of(found);
}

// A value that a map gives; "" if there is none in sight.
std::string RandomProgram::from_map(const Ty* type, int depth) {
  const bool is_list = type->is(Sort::kList);
  if (is_list && one_in(2)) {
    if (const Var* map = find_map(type->element, nullptr, false)) return map->name + ".keys()";
    if (const Var* map = find_map(nullptr, type->element, false)) return map->name + ".values()";
  }
  if (type->is(Sort::kInt) && one_in(4)) {
    if (const Var* map = find_map(nullptr, nullptr, false)) return map->name + ".length";
  }
  if (type->is(Sort::kBool)) {
    const Var* map = find_map(nullptr, nullptr, false);
    if (map == nullptr) return "";
    const std::string name = map->name;
    return name + ".has(" + key_of(map->type, depth - 1) + ")";
  }
  const bool takes = !in_format_ && one_in(6);
  const Var* found = find_map(nullptr, type, takes);
  if (found == nullptr) return "";
  const std::string name = found->name;
  const std::string key = key_of(found->type, depth - 1);
  if (takes) return name + ".remove(" + key + ")";
  if (one_in(3)) return name + "[" + key + "]";
  return name + ".get(" + key + ", " + expr(type, depth - 1) + ")";
}

void RandomProgram::map_statement() {
  const Var* found = find_map(nullptr, nullptr, true);
  if (found == nullptr || one_in(4)) {
    const Ty* type = some_map();
    const std::string name = fresh();
    line("var " + name + ": " + type->name + " = " + (one_in(4) ? "[:]" : expr(type, 2)));
    vars_.push_back({name, type, true});
    return;
  }
  const std::string name = found->name;
  const Ty* type = found->type;
  const std::string entry = name + "[" + key_of(type, 1) + "]";
  const bool is_number = type->element->is(Sort::kInt) || type->element->is(Sort::kReal);
  switch (below(6)) {
    case 0:
      return line("print(" + name + ".remove(" + key_of(type, 1) + "), " + name + ")");
    case 1:
      if (is_number) return line(entry + (one_in(2) ? " += " : " -= ") + expr(type->element, 2));
      if (type->element->is(Sort::kList)) return line(entry + ".push(" + leaf(int_) + ")");
      if (type->element->is(Sort::kMap)) return line(entry + "[\"a\"] = " + leaf(int_));
      [[fallthrough]];
    case 2:
      return visit_map(name, type);
    default:
      return line(entry + " = " + loose(type->element, 2));
  }
}

// The map is changed while it is visited.
void RandomProgram::visit_map(const std::string& name, const Ty* type) {
  const std::string key = fresh();
  const std::string value = one_in(3) ? "" : fresh();
  const std::size_t vars = vars_.size();
  open("for (" + key + (value.empty() ? "" : ", " + value) + " in " + name + ")");
  ++loops_;
  vars_.push_back({key, type->key, false});
  if (!value.empty()) vars_.push_back({value, type->element, false});
  if (one_in(2))
    line("if (" + name + ".length < 8) { " + name + "[" + key_of(type, 0) +
         "] = " + leaf(type->element) + " }");
  if (one_in(3)) line("if (" + name + ".has(" + key + ")) { " + name + ".remove(" + key + ") }");
  simple();
  leaving();
  vars_.resize(vars);
  --loops_;
  close();
}

}  // namespace armlet::oracle
