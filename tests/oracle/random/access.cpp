// Values that come from somewhere else: calls, elements, fields, choices, lists that give something
// up.

#include "random/program.hpp"

namespace armlet::oracle {

std::string RandomProgram::from_elsewhere(const Ty* type, int depth) {
  switch (below(8)) {
    case 7:
      return from_map(type, depth);
    case 0:
    case 1:
      return calls_left_ > 0 && loops_ < 2 ? call(type, depth) : "";
    case 2:
      return element(type, depth);
    case 3:
      return field(type, depth);
    case 4:
      return in_format_ ? "" : taken(type);
    case 5:
      return calls_left_ > 0 && loops_ < 2 ? call_value(type, depth) : "";
    default:
      if (type->is(Sort::kFunction)) return "";
      return "(" + truth(depth - 1) + " ? " + expr(type, depth - 1) + " : " +
             expr(type, depth - 1) + ")";
  }
}

std::string RandomProgram::call(const Ty* type, int depth) {
  std::vector<const Function*> fitting;
  for (const Function& function : functions_) {
    const bool doubles = type->is(Sort::kInt) || type->is_floating() || type->is(Sort::kText);
    if (function.is_generic ? doubles : function.result == type) fitting.push_back(&function);
  }
  if (fitting.empty()) return "";
  --calls_left_;
  const Function& function = *one_of(fitting);
  if (function.is_generic) return function.name + "(" + expr(type, depth - 1) + ")";
  const bool is_method = function.parameters.size() == 1 && one_in(3) &&
                         !function.parameters[0].type->is(Sort::kFunction);
  if (is_method)
    return "(" + expr(function.parameters[0].type, depth - 1) + ")." + function.name + "()";
  return function.name + "(" + arguments(function, depth - 1) + ")";
}

// By position, then some by name in any order.
std::string RandomProgram::arguments(const Function& function, int depth) {
  std::string out;
  const std::size_t count = function.parameters.size();
  const std::size_t by_position = one_in(3) ? below(count + 1) : count;
  const bool backwards = one_in(2);
  for (std::size_t i = 0; i < count; ++i) {
    const Field& parameter = function.parameters[i];
    if (!parameter.first.empty() && one_in(2)) continue;
    std::string next = loose(parameter.type, depth);
    if (i >= by_position) next = parameter.name + ": " + next;
    const bool first = backwards && by_position == 0;
    out = out.empty() ? next : first ? next + ", " + out : out + ", " + next;
  }
  return out;
}

std::string RandomProgram::call_value(const Ty* type, int depth) {
  std::vector<const Var*> fitting;
  for (const Var& variable : vars_) {
    if (variable.type->is(Sort::kFunction) && variable.type->result == type)
      fitting.push_back(&variable);
  }
  if (fitting.empty()) return "";
  --calls_left_;
  const Var& function = *one_of(fitting);
  std::string out;
  for (const Ty* parameter : function.type->parameters)
    out += (out.empty() ? "" : ", ") + loose(parameter, depth - 1);
  return function.name + "(" + out + ")";
}

// As an index: what the text shows to be below 0 is refused before the run, so a call hides it.
std::string RandomProgram::index(const std::string& number) {
  const bool is_written = number.find_first_not_of("0123456789") == std::string::npos;
  return is_written ? number : "as_index(" + number + ")";
}

// Mostly an index that exists.
std::string RandomProgram::index_of(const std::string& list, int depth) {
  switch (below(6)) {
    case 0:
      return "abs(" + expr(int_, depth) + " % " + list + ".length)";
    case 1:
      return index(expr(int_, depth));
    case 2:
      return list + ".length - 1";
    case 3:
      return index(leaf(int_));
    default:
      return std::to_string(below(2));
  }
}

std::string RandomProgram::element(const Ty* type, int depth) {
  const Ty* wanted = list_of(type);
  if (const Var* found = find(wanted)) {
    const std::string name = found->name;
    return one_in(8) ? name + ".last" : name + "[" + index_of(name, depth - 1) + "]";
  }
  if (const Var* rows = find(list_of(wanted))) {
    const std::string name = rows->name;
    return name + "[" + index_of(name, depth - 1) + "][" + index(leaf(int_)) + "]";
  }
  return "";
}

std::string RandomProgram::field(const Ty* type, int depth) {
  for (const Struct& shape : structs_) {
    for (const Field& field : shape.fields) {
      if (field.type != type || one_in(3)) continue;
      if (const Var* found = find(shape.type)) return found->name + "." + field.name;
      if (const Var* found = find(list_of(shape.type))) {
        const std::string name = found->name;
        return name + "[" + index_of(name, depth - 1) + "]." + field.name;
      }
    }
  }
  return "";
}

// Something that a list gives up while the rest is being computed.
std::string RandomProgram::taken(const Ty* type) {
  const Var* found = find(list_of(type), true);
  if (found == nullptr) return "";
  const std::string name = found->name;
  return one_in(2) ? name + ".pop()" : name + ".removeAt(" + std::to_string(below(2)) + ")";
}

}  // namespace armlet::oracle
