// Programs as a whole: types, variables, functions, and the main text.

#include "random/program.hpp"

#include <utility>

namespace armlet::oracle {

std::string RandomProgram::text() {
  has_tasks_ = one_in(4) || tasks_wanted_;
  tasks_left_ = 4;
  make_types();
  declare_types();
  declare_globals();
  declare_helpers();
  const bool is_large = one_in(8);
  const std::size_t functions = below(is_large ? 4 : 3);
  for (std::size_t i = 0; i < functions; ++i) declare_function();
  if (one_in(3)) declare_leaf();
  if (one_in(4)) declare_generic();
  if (one_in(5)) declare_recursive();
  if (one_in(8)) declare_late();
  if (one_in(3)) declare_kernel();
  if (one_in(2)) declare_table();
  if (one_in(3)) declare_handing();
  if (one_in(2)) declare_operands();
  if (one_in(3)) declare_unset();
  const std::size_t globals = vars_.size();
  const bool shows_end = !one_in(4);
  statements_left_ = (is_large ? 12 : 4) + static_cast<int>(below(8));
  if (shows_end) open("try");
  while (statements_left_ > 0) statement();
  vars_.resize(globals);
  if (shows_end) close(" finally {");
  std::string all = "print(";
  for (const Var& variable : vars_) all += (all.size() > 6 ? ", " : "") + variable.name;
  if (has_grid_) all += ", grid";
  line(all + (has_tasks_ ? ", now())" : ")"));
  if (shows_end) close();
  return out_;
}

// ---- types

void RandomProgram::make_types() {
  const auto add = [&](Sort sort, const char* name) {
    types_.push_back({sort, name});
    return &types_.back();
  };
  int_ = add(Sort::kInt, "int");
  real_ = add(Sort::kReal, "double");
  bool_ = add(Sort::kBool, "bool");
  text_ = add(Sort::kText, "string");
  length_ = add(Sort::kLength, "length");
  angle_ = add(Sort::kAngle, "angle");
  time_ = add(Sort::kTime, "time");
}

const Ty* RandomProgram::list_of(const Ty* element) {
  for (const Ty& type : types_) {
    if (type.is(Sort::kList) && type.element == element) return &type;
  }
  types_.push_back({Sort::kList, element->name + "[]", element});
  return &types_.back();
}

const Ty* RandomProgram::function_type(std::vector<const Ty*> parameters, const Ty* result) {
  for (const Ty& type : types_) {
    if (type.is(Sort::kFunction) && type.parameters == parameters && type.result == result)
      return &type;
  }
  std::string name = "fn(";
  for (const Ty* parameter : parameters) name += (name.size() > 3 ? ", " : "") + parameter->name;
  types_.push_back(
      {Sort::kFunction, name + ") -> " + result->name, nullptr, 0, std::move(parameters), result});
  return &types_.back();
}

const Ty* RandomProgram::scalar() {
  const std::size_t which = below(12);
  if (which < 4) return int_;
  if (which < 7) return real_;
  if (which == 7) return bool_;
  if (which < 10) return text_;
  if (which == 10 && !enums_.empty()) return one_of(enums_);
  return one_of(std::vector<const Ty*>{length_, angle_, time_});
}

const Ty* RandomProgram::storable() {
  if (one_in(10)) return some_map();
  switch (below(10)) {
    case 0:
    case 1:
      return list_of(int_);
    case 2:
      return list_of(real_);
    case 3:
      return list_of(one_in(2) ? text_ : list_of(int_));
    case 4:
    case 5:
      if (!structs_.empty())
        return one_in(3) ? list_of(one_of(structs_).type) : one_of(structs_).type;
      [[fallthrough]];
    default:
      return scalar();
  }
}

bool RandomProgram::comparable(const Ty* type) const {
  if (type->is(Sort::kList) || type->is(Sort::kMap)) return comparable(type->element);
  if (type->is(Sort::kStruct)) return structs_[type->id].comparable;
  return !type->is(Sort::kFunction);
}

void RandomProgram::declare_types() {
  if (one_in(2)) {
    const std::size_t count = 2 + below(3);
    std::vector<std::string> values;
    for (std::size_t i = 0; i < count; ++i)
      values.push_back(std::string(1, static_cast<char>('A' + i)));
    types_.push_back({Sort::kEnum, "State", nullptr, enums_.size()});
    enums_.push_back(&types_.back());
    std::string all;
    for (const std::string& value : values) all += (all.empty() ? "" : ", ") + value;
    line("enum State { " + all + " }");
    enum_values_.push_back(std::move(values));
  }
  const std::size_t structs = below(4) == 0 ? 0 : 1 + below(2);
  for (std::size_t i = 0; i < structs; ++i) declare_struct();
}

void RandomProgram::declare_struct() {
  Struct made;
  types_.push_back(
      {Sort::kStruct, "S" + std::to_string(structs_.size()), nullptr, structs_.size()});
  made.type = &types_.back();
  std::string all;
  const std::size_t fields = 1 + below(4);
  for (std::size_t i = 0; i < fields; ++i) {
    Field field{"m" + std::to_string(i), storable(), ""};
    if (one_in(6)) field.type = function_type({int_}, int_);
    made.comparable = made.comparable && comparable(field.type);
    if (one_in(3)) field.first = constant(field.type);
    all += (all.empty() ? "" : "; ") + field.name + ": " + field.type->name;
    if (!field.first.empty()) all += " = " + field.first;
    made.fields.push_back(std::move(field));
  }
  line("struct " + made.type->name + " { " + all + " }");
  structs_.push_back(std::move(made));
}

// ---- variables and functions of the program

void RandomProgram::declare_globals() {
  line("var counter = 0");
  line("fn as_index(i: int) -> int { return i }");
  line("var pile = [5, 6, 7, 8]");
  vars_ = {{"counter", int_, true}, {"pile", list_of(int_), true}};
  const bool with_grid = one_in(4);
  if (with_grid) line("var grid = [1, 2, 3; 4.5, " + real(1) + ", 6]");
  has_grid_ = with_grid;
  const std::size_t count = 2 + below(4);
  for (std::size_t i = 0; i < count; ++i) {
    const Ty* type = storable();
    const std::string name = "g" + std::to_string(i);
    line("var " + name + ": " + type->name + " = " + loose(type, 1));
    vars_.push_back({name, type, true});
  }
}

// They show when they are called, change what others read, or are small enough to be put in place
// of their calls.
void RandomProgram::declare_helpers() {
  const auto add = [&](const std::string& text, Function function) {
    if (one_in(2)) return;
    line(text);
    functions_.push_back(std::move(function));
  };
  const Ty* ints = list_of(int_);
  if (has_tasks_) line("fn looked(b: bool) -> bool { print(\"looks at\", now(), b); return b }");
  add("fn seen(n: int) -> int { print(\"seen\", n); return n }", {"seen", {{"n", int_, ""}}, int_});
  add("fn told(b: bool) -> bool { print(\"told\", b); return b }",
      {"told", {{"b", bool_, ""}}, bool_});
  add("fn bump() -> int { counter += 1; return counter }", {"bump", {}, int_});
  add("fn shrink() -> int { if (pile.length > 1) { pile.pop() }; pile[0] += 1; return pile.length "
      "}",
      {"shrink", {}, int_});
  add("fn grow(n: int) -> int { if (pile.length < 9) { pile.push(n) }; return n }",
      {"grow", {{"n", int_, ""}}, int_});
  add("fn at(xs: int[], i: int) => xs[i]", {"at", {{"xs", ints, ""}, {"i", int_, ""}}, int_});
  add("fn part(a: int, b: int) -> int { return a / b }",
      {"part", {{"a", int_, ""}, {"b", int_, ""}}, int_});
  add("fn norm2(x: double, y: double) => sqrt(x * x + y * y)",
      {"norm2", {{"x", real_, ""}, {"y", real_, ""}}, real_});
  add("fn renew() -> int[] { pile = [counter, 1, 2]; return pile }", {"renew", {}, ints});
  add("fn join2(s: string, n: int) -> string { return s + n }",
      {"join2", {{"s", text_, ""}, {"n", int_, ""}}, text_});
}

void RandomProgram::declare_function() {
  Function made{"f" + std::to_string(functions_.size()), {}, storable()};
  const std::size_t globals = vars_.size();
  const std::size_t parameters = below(4);
  std::string all;
  for (std::size_t i = 0; i < parameters; ++i) {
    Field parameter{fresh(), one_in(6) ? function_type({int_}, int_) : storable(), ""};
    const bool may_be_left_out = i + 1 == parameters && !parameter.type->is(Sort::kFunction);
    if (may_be_left_out && one_in(2)) parameter.first = constant(parameter.type);
    all += (all.empty() ? "" : ", ") + parameter.name + ": " + parameter.type->name;
    if (!parameter.first.empty()) all += " = " + parameter.first;
    made.parameters.push_back(std::move(parameter));
  }
  for (const Field& parameter : made.parameters)
    vars_.push_back({parameter.name, parameter.type, false});
  open("fn " + made.name + "(" + all + ") -> " + made.result->name);
  result_ = made.result;
  statements_left_ = 1 + static_cast<int>(below(3));
  while (statements_left_ > 0) statement();
  calls_left_ = 1;
  line("return " + loose(made.result, 2));
  close();
  result_ = nullptr;
  vars_.resize(globals);
  functions_.push_back(std::move(made));
}

// Checked once for every type it is called with.
void RandomProgram::declare_generic() {
  Function made{"twofold" + std::to_string(functions_.size()), {{"x", nullptr, ""}}, nullptr, true};
  if (one_in(2)) {
    line("fn " + made.name + "(x) => x + x");
  } else {
    line("fn " + made.name + "(x) { var y = x");
    line("  y += x; return y }");
  }
  functions_.push_back(std::move(made));
}

// A small function that calls none.
void RandomProgram::declare_leaf() {
  const bool whole = one_in(2);
  Function made{"generic" + std::to_string(functions_.size()),
                {{"a", int_, ""}, {"b", real_, ""}, {"xs", list_of(real_), ""}},
                whole ? int_ : real_};
  const std::size_t globals = vars_.size();
  for (const Field& parameter : made.parameters)
    vars_.push_back({parameter.name, parameter.type, false});
  calls_left_ = 0;
  recent_.clear();
  open("fn " + made.name + "(a: int, b: double, xs: double[]) -> " + made.result->name);
  if (one_in(2)) {
    const std::string name = fresh();
    line("var " + name + " = " + expr(made.result, 2));
    vars_.push_back({name, made.result, true});
    if (one_in(2)) line("if (" + truth(1) + ") { " + name + " += " + expr(made.result, 1) + " }");
  }
  if (one_in(3)) line("if (" + truth(1) + ") { return " + expr(made.result, 1) + " }");
  line("return " + expr(made.result, 2));
  close();
  vars_.resize(globals);
  functions_.push_back(std::move(made));
}

// Its first parameter counts down, so it ends; one of them does not.
void RandomProgram::declare_recursive() {
  const std::string name = "deep" + std::to_string(functions_.size());
  if (one_in(3)) {
    line("fn " + name + "(n: int) -> int { return 1 + " + name + "(n + 1) }");
    line("try { print(" + name + "(0)) } catch (e) { print(e.kind, e.line) }");
    return;
  }
  const Ty* result = scalar();
  recent_.clear();
  const std::size_t globals = vars_.size();
  vars_.push_back({"n", int_, false});
  vars_.push_back({"x", result, false});
  calls_left_ = 0;
  open("fn " + name + "(n: int, x: " + result->name + ") -> " + result->name);
  line("if (n <= 0) { return x }");
  line("if (" + truth(1) + ") { return " + loose(result, 1) + " }");
  line("return " + name + "(n - 1, " + loose(result, 2) + ")");
  close();
  vars_.resize(globals);
  calls_left_ = 2;
  line("try { print(" + name + "(" + std::to_string(below(7)) + ", " + leaf(result) +
       ")) } catch (e) { print(e.message) }");
}

// A function that may run before the variable it uses has a value.
void RandomProgram::declare_late() {
  line("fn early(n: int) -> int { late += n; return late }");
  line("try { print(early(1)) } catch (e) { print(e.message, e.line) }");
  line("var late = " + integer(1));
  line("print(early(2))");
  vars_.push_back({"late", int_, true});
}

// Defaults are values written in the text; "" for types that have none.
std::string RandomProgram::constant(const Ty* type) {
  const Ty* item = type->is(Sort::kList) ? type->element : type;
  if (item->is(Sort::kList) || item->is(Sort::kStruct) || item->is(Sort::kFunction) ||
      item->is(Sort::kMap))
    return "";
  const std::deque<Var> hidden = std::exchange(vars_, {});
  std::string out = literal(type);
  vars_ = hidden;
  return out;
}

// ---- names in sight

std::vector<const RandomProgram::Var*> RandomProgram::visible(const Ty* type, bool to_change) {
  std::vector<const Var*> found;
  for (std::size_t i = 0; i < vars_.size(); ++i) {
    const bool fits = vars_[i].type == type;
    if (fits && (!to_change || (vars_[i].can_change && i >= first_changeable_)))
      found.push_back(&vars_[i]);
  }
  return found;
}

const RandomProgram::Var* RandomProgram::find(const Ty* type, bool to_change) {
  const std::vector<const Var*> found = visible(type, to_change);
  return found.empty() ? nullptr : one_of(found);
}

const RandomProgram::Var* RandomProgram::find_list(bool to_change) {
  std::vector<const Var*> found;
  for (std::size_t i = 0; i < vars_.size(); ++i) {
    const bool allowed = !to_change || (vars_[i].can_change && i >= first_changeable_);
    if (vars_[i].type->is(Sort::kList) && allowed) found.push_back(&vars_[i]);
  }
  return found.empty() ? nullptr : one_of(found);
}

}  // namespace armlet::oracle
