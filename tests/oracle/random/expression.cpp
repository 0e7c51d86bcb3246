// Expressions of a given type. Operands stand in parentheses, so that nobody has to think about
// priorities.

#include "random/program.hpp"

namespace armlet::oracle {

std::string RandomProgram::expr(const Ty* type, int depth) {
  if (depth <= 0 || one_in(5)) return leaf(type);
  if (one_in(3)) {
    if (std::string found = from_elsewhere(type, depth); !found.empty()) return found;
  }
  switch (type->sort) {
    case Sort::kInt:
      return integer(depth);
    case Sort::kReal:
      return real(depth);
    case Sort::kBool:
      return truth(depth);
    case Sort::kText:
      return text_expr(depth);
    case Sort::kList:
      return list(type, depth);
    case Sort::kMap:
      return map_literal(type, depth);
    case Sort::kStruct:
      return record(type, depth);
    case Sort::kEnum:
      return enum_value(type, depth);
    case Sort::kFunction:
      return function_value(type);
    default:
      return quantity(type, depth);
  }
}

std::string RandomProgram::loose(const Ty* type, int depth) {
  if (type->is(Sort::kReal) && one_in(5)) return integer(depth);
  if (type->is(Sort::kReal) && one_in(12)) return expr(angle_, depth);
  if (type->is_list_of(Sort::kReal) && one_in(6)) return expr(list_of(int_), depth);
  if (type->is_quantity() && one_in(12)) return "0";
  return expr(type, depth);
}

std::string RandomProgram::leaf(const Ty* type) {
  if (!one_in(3)) {
    if (const Var* variable = find(type)) return variable->name;
  }
  return literal(type);
}

std::string RandomProgram::literal(const Ty* type) {
  static const std::vector<std::string> kInts = {"9223372036854775807", "4611686018427387904", "-1",
                                                 "1000003", "3037000500"};
  static const std::vector<std::string> kReals = {"0.1", "2.5", "1e15",  "1e-7", "123456.789",
                                                  "0.0", "3.0", "1e300", "0.3"};
  static const std::vector<std::string> kTexts = {"a",      "h\u00e9llo", "\u2192x", "",
                                                  "Zz top", "12",         "x,y,z"};
  switch (type->sort) {
    case Sort::kInt:
      return one_in(12) ? one_of(kInts) : std::to_string(below(7));
    case Sort::kReal:
      return one_in(2) ? one_of(kReals) : std::to_string(below(5)) + ".25";
    case Sort::kBool:
      return one_in(2) ? "true" : "false";
    case Sort::kText:
      return in_format_ ? "'" + one_of(kTexts) + "'" : "\"" + one_of(kTexts) + "\"";
    case Sort::kLength:
      return std::to_string(1 + below(1500)) + (one_in(2) ? "mm" : ".5cm");
    case Sort::kAngle:
      return std::to_string(below(180)) + (one_in(4) ? "rad" : "deg");
    case Sort::kTime:
      return std::to_string(below(9)) + (one_in(3) ? "ms" : ".5s");
    case Sort::kList: {
      std::string items;
      const std::size_t count = 1 + below(4);
      for (std::size_t i = 0; i < count; ++i) items += (i == 0 ? "" : ", ") + leaf(type->element);
      return "[" + items + "]";
    }
    case Sort::kMap:
      return map_literal(type, 0);
    case Sort::kStruct:
      return record(type, 0);
    case Sort::kEnum:
      return type->name + "." + one_of(enum_values_[type->id]);
    case Sort::kFunction:
      return function_value(type);
  }
  return "";
}

// ---- numbers

std::string RandomProgram::integer(int depth) {
  if (depth <= 0) return leaf(int_);
  const std::string a = expr(int_, depth - 1);
  const auto b = [&] { return expr(int_, depth - 1); };
  switch (below(17)) {
    case 0:
    case 1:
      return "(" + a + " + " + b() + ")";
    case 2:
      return "(" + a + " - " + b() + ")";
    case 3:
      return "(" + a + " * " + b() + ")";
    case 4:
      return "((" + a + " * " + b() + ") % 1000)";
    case 5:
      return "(" + a + " / " + b() + ")";
    case 6:
      return "(" + a + " % " + b() + ")";
    case 7:
      return "((" + a + ") ^ " + (one_in(4) ? "(counter - 2)" : std::to_string(below(5))) + ")";
    case 8:
      return "(-(" + a + "))";
    case 9:
      if (const Var* found = find_list(false)) return found->name + ".length";
      return "(" + a + " + 1)";
    case 10:
      return "(" + expr(text_, 0) + ").length";
    case 11:
      return one_in(3) ? "int(" + real(depth - 1) + ")" : "round(" + real(0) + ")";
    case 12:
      return "abs(" + a + ")";
    case 13:
      return std::string(one_in(2) ? "min(" : "max(") + a + ", " + b() + ")";
    case 14:
      return "sum(" + expr(list_of(int_), depth - 1) + ")";
    case 15:
      if (one_in(2)) return "indexOf(" + expr(list_of(int_), 0) + ", " + a + ")";
      if (one_in(2)) {
        // An int to start from becomes a number of the list's own kind.
        const Ty* any = scalar();
        const Ty* element = any->is_floating() ? int_ : any;
        return "fold(" + expr(list_of(element), 0) + ", " + a + ", " +
               lambda(function_type({int_, element}, int_)) + ")";
      }
      return "clamp(" + a + ", 0, 9)";
    default:
      return "(" + a + " + " + b() + " - 1)";
  }
}

// Often the same expression again.
std::string RandomProgram::real(int depth) {
  const std::string newest = vars_.empty() ? "" : vars_.back().name;
  std::erase_if(recent_, [&](const Recent& r) { return r.newest != newest; });
  if (!recent_.empty() && one_in(6)) {
    const Recent& again = one_of(recent_);
    if (again.in_format == in_format_) return again.text;
  }
  std::string made = new_real(depth);
  if (depth > 0 && made.size() < 60) recent_.push_back({made, newest, in_format_});
  if (recent_.size() > 4) recent_.erase(recent_.begin());
  return made;
}

std::string RandomProgram::new_real(int depth) {
  if (depth <= 0) return leaf(real_);
  if (has_grid_ && one_in(6))
    return "grid[" + index(leaf(int_)) + ", " + index(expr(int_, depth - 1) + " % 3") + "]";
  const std::string a = expr(real_, depth - 1);
  const auto b = [&] { return expr(real_, depth - 1); };
  switch (below(16)) {
    case 0:
      return "(" + a + " * " + b() + " + " + b() + ")";
    case 1:
      return "(" + a + " + " + b() + " * " + b() + ")";
    case 2:
      return "(" + a + " - " + b() + " * " + b() + ")";
    case 3:
      return "(" + a + " / (" + b() + "))";
    case 4:
      return "(" + integer(depth - 1) + " * " + a + ")";
    case 5:
      return "(" + a + " - " + integer(depth - 1) + ")";
    case 6:
      return "(" + a + " % " + b() + ")";
    case 7:
      return "((" + a + ") ^ " + (one_in(3) ? b() : std::to_string(below(4))) + ")";
    case 8:
      return "(-(" + a + "))";
    case 9:
      return "sqrt(" + (one_in(4) ? a : "abs(" + a + ")") + ")";
    case 10:
      return one_in(2) ? "hypot(" + a + ", " + b() + ")" : "sin(" + a + ")";
    case 11:
      return "double(" + integer(depth - 1) + ")";
    case 12:
      return "(" + quantity(length_, depth - 1) + " / 1mm)";
    case 13:
      return "sum(" + expr(list_of(real_), depth - 1) + ")";
    case 14:
      return std::string(one_in(2) ? "floor(" : "max(0.5, ") + a + ")";
    default:
      return "(" + a + " + " + b() + " + " + b() + ")";
  }
}

std::string RandomProgram::quantity(const Ty* type, int depth) {
  if (depth <= 0) return leaf(type);
  const std::string a = expr(type, depth - 1);
  switch (below(7)) {
    case 0:
      return "(" + a + " + " + expr(type, depth - 1) + ")";
    case 1:
      return "(" + a + " - " + expr(type, depth - 1) + ")";
    case 2:
      return "(" + a + " * " + real(depth - 1) + ")";
    case 3:
      return "(" + a + " / " + (one_in(2) ? real(0) : std::to_string(1 + below(4))) + ")";
    case 4:
      return "(-(" + a + "))";
    case 5:
      return "max(" + a + ", " + expr(type, depth - 1) + ")";
    default:
      return "sqrt(" + a + " * " + a + ")";
  }
}

std::string RandomProgram::truth(int depth) {
  static const std::vector<std::string> kOrder = {" < ", " <= ", " > ", " >= ", " == ", " != "};
  static const std::vector<std::string> kSame = {" == ", " != "};
  if (depth <= 0)
    return one_in(3) ? leaf(bool_) : "(" + leaf(int_) + one_of(kOrder) + leaf(int_) + ")";
  switch (below(9)) {
    case 0:
      return "(" + truth(depth - 1) + " && " + truth(depth - 1) + ")";
    case 1:
      return "(" + truth(depth - 1) + " || " + truth(depth - 1) + ")";
    case 2:
      return "!(" + truth(depth - 1) + ")";
    case 3:
      return "(" + expr(real_, depth - 1) + one_of(kOrder) + expr(real_, depth - 1) + ")";
    case 4:
      return "(" + expr(text_, depth - 1) + one_of(kOrder) + expr(text_, depth - 1) + ")";
    case 5: {
      const Ty* type = storable();
      if (!comparable(type)) return leaf(bool_);
      return "(" + expr(type, depth - 1) + one_of(kSame) + expr(type, depth - 1) + ")";
    }
    case 6:
      if (one_in(2)) {
        const Ty* element = scalar();
        return std::string(one_in(2) ? "any(" : "all(") + expr(list_of(element), 0) + ", " +
               visitor(element, bool_) + ")";
      }
      return "startsWith(" + expr(text_, depth - 1) + ", " + expr(text_, depth - 1) + ")";
    default:
      return "(" + expr(int_, depth - 1) + one_of(kOrder) + expr(int_, depth - 1) + ")";
  }
}

// ---- texts

std::string RandomProgram::text_expr(int depth) {
  if (depth <= 0) return leaf(text_);
  const std::string a = expr(text_, depth - 1);
  switch (below(9)) {
    case 0:
    case 1:
      return "(" + a + " + " + expr(one_in(2) ? text_ : scalar(), depth - 1) + ")";
    case 2:
      return "(" + a + " + " + literal(text_) + " + " + expr(scalar(), depth - 1) + ")";
    case 3:
      return "(" + a + ")[" + (one_in(2) ? "0" : index(expr(int_, depth - 1))) + "]";
    case 4:
      return "(" + a + ")[" + (one_in(2) ? "" : std::to_string(below(3))) + ":" +
             (one_in(2) ? "" : index(expr(int_, 0))) + "]";
    case 5:
      return "(" + a + ")." + (one_in(2) ? "upper()" : "trim()");
    case 6:
      return "join(" + expr(list_of(text_), depth - 1) + ", " + literal(text_) + ")";
    default:
      return in_format_ ? a : formatted(depth);
  }
}

std::string RandomProgram::formatted(int depth) {
  in_format_ = true;
  std::string out = "f\"";
  const std::size_t pieces = 1 + below(3);
  for (std::size_t i = 0; i < pieces; ++i) {
    if (one_in(2)) out += one_in(4) ? "{{}}" : "x = ";
    out += "{" + piece(depth - 1) + "}";
  }
  in_format_ = false;
  return out + "\"";
}

std::string RandomProgram::piece(int depth) {
  static const std::vector<std::string> kNumber = {"",       ":.2f", ":.3e",  ":g",      ":.0f",
                                                   ":.4g",   ":e",   ":8.2f", ":+.1f",   ":<12",
                                                   ":^9.3g", ":+",   ":05",   ":012.2f", ":>3"};
  static const std::vector<std::string> kLength = {"",       ":.1f mm",   ": cm",     ":.2f",
                                                   ":.3g m", ":12.2f mm", ":+.1f mm", ":<14"};
  static const std::vector<std::string> kAngle = {"",     ":.1f deg",   ": rad",
                                                  ":.0f", ":09.2f deg", ":^14"};
  static const std::vector<std::string> kWord = {"", "", ":<8", ":>8", ":^7", ":12"};
  const Ty* type = one_in(4) ? storable() : scalar();
  const std::string value = expr(type, depth);
  const bool has_elements = type->is(Sort::kList) || type->is(Sort::kMap);
  const Ty* number = has_elements ? type->element : type;
  if (number->is(Sort::kInt) || number->is(Sort::kReal)) return value + one_of(kNumber);
  if (type->is(Sort::kLength)) return value + one_of(kLength);
  if (type->is(Sort::kAngle)) return value + one_of(kAngle);
  if (type->is(Sort::kText) || type->is(Sort::kBool)) return value + one_of(kWord);
  return value;
}

// ---- lists, structs, enums, functions

std::string RandomProgram::list(const Ty* type, int depth) {
  if (depth <= 0) return leaf(type);
  if (has_grid_ && type->is_list_of(Sort::kReal) && one_in(4)) {
    return one_in(2) ? "grid[" + index(leaf(int_)) + ", " + stretch() + "]"
                     : "grid[:, " + index(leaf(int_)) + "]";
  }
  if (one_in(8)) {
    const Ty* element = scalar();
    return "map(" + expr(list_of(element), 0) + ", " + visitor(element, type->element) + ")";
  }
  if (one_in(12))
    return "filter(" + expr(type, depth - 1) + ", " + visitor(type->element, bool_) + ")";
  if (one_in(16))
    return "sort(" + expr(type, depth - 1) + ", by: " + visitor(type->element, int_) + ")";
  const bool numbers = type->element->is(Sort::kInt) || type->element->is(Sort::kReal);
  switch (below(10)) {
    case 0: {
      std::string items;
      const std::size_t count = 1 + below(4);
      for (std::size_t i = 0; i < count; ++i)
        items += (i == 0 ? "" : ", ") + expr(type->element, depth - 1);
      return "[" + items + "]";
    }
    case 1:
      return "(" + expr(type, depth - 1) + ")[" + (one_in(2) ? "" : std::to_string(below(3))) +
             ":" + (one_in(2) ? "" : index(expr(int_, 0))) + "]";
    case 2:
      return "reverse(" + expr(type, depth - 1) + ")";
    case 3:
      if (numbers)
        return "(" + expr(type, depth - 1) + (one_in(2) ? " + " : " - ") + expr(type, depth - 1) +
               ")";
      break;
    case 4:
      if (numbers) return "(" + expr(type, depth - 1) + " .* " + expr(type, depth - 1) + ")";
      break;
    case 5:
      if (type->element->is(Sort::kReal))
        return "(" + expr(type, depth - 1) + " * " + real(depth - 1) + ")";
      if (type->element->is(Sort::kInt)) return "range(" + std::to_string(below(5)) + ", 6)";
      break;
    case 6:
      if (numbers) return "sort(" + expr(type, depth - 1) + ")";
      break;
    case 7:
      if (numbers && !in_format_)
        return "(new " + type->name.substr(0, type->name.size() - 2) + "[" + leaf(int_) + " % 5])";
      if (type->element->is(Sort::kStruct) && !in_format_ && one_in(3))
        return "(new " + type->element->name + "[2])";
      break;
    default:
      break;
  }
  return literal(type);
}

std::string RandomProgram::record(const Ty* type, int depth) {
  const Struct& shape = structs_[type->id];
  std::string fields;
  for (const Field& field : shape.fields) {
    if (!field.first.empty() && one_in(2)) continue;
    fields += (fields.empty() ? "" : ", ") + field.name + ": " + loose(field.type, depth - 1);
  }
  return type->name + "(" + fields + ")";
}

std::string RandomProgram::enum_value(const Ty* type, int depth) {
  if (depth > 0 && one_in(4))
    return "(" + type->name + ".values)[" + std::to_string(below(2)) + "]";
  const std::string value = literal(type);
  return depth > 1 ? "(" + truth(depth - 1) + " ? " + value + " : " + leaf(type) + ")" : value;
}

std::string RandomProgram::function_value(const Ty* type) {
  if (one_in(3)) {
    for (const Function& function : functions_) {
      const bool fits = !function.is_generic && function.result == type->result &&
                        function.parameters.size() == 1 &&
                        function.parameters[0].type == type->parameters[0];
      if (fits) return function.name;
    }
  }
  return lambda(type);
}

// What map, filter and their like call.
std::string RandomProgram::visitor(const Ty* element, const Ty* result) {
  return lambda(function_type({element}, result));
}

// It sees what is in sight, but cannot change it.
std::string RandomProgram::lambda(const Ty* type) {
  const std::size_t before = vars_.size();
  const std::size_t changeable = first_changeable_;
  first_changeable_ = before;
  std::string parameters;
  for (const Ty* parameter : type->parameters) {
    const std::string name = fresh();
    parameters += (parameters.empty() ? "" : ", ") + name + ": " + parameter->name;
    vars_.push_back({name, parameter, false});
  }
  const int calls = calls_left_;
  calls_left_ = 0;
  std::string out = "fn(" + parameters + ") => " + expr(type->result, 2);
  calls_left_ = calls;
  vars_.resize(before);
  first_changeable_ = changeable;
  return out;
}

}  // namespace armlet::oracle
