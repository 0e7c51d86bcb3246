// Statements that store and show values.

#include "random/program.hpp"

namespace armlet::oracle {

void RandomProgram::statement() {
  --statements_left_;
  calls_left_ = loops_ == 0 ? 2 : 1;
  if (nesting_ >= 3 || one_in(2)) {
    simple();
    return;
  }
  ++nesting_;
  const std::size_t vars = vars_.size();
  if (has_tasks_ && tasks_left_ > 0 && !in_lambda_ && one_in(3)) {
    concurrent();
    vars_.resize(vars);
    --nesting_;
    return;
  }
  switch (below(13)) {
    case 0:
    case 1:
      conditional();
      break;
    case 2:
      counted();
      break;
    case 3:
      ranged();
      break;
    case 4:
      visiting();
      break;
    case 5:
      repeating();
      break;
    case 6:
    case 7:
      choosing();
      break;
    case 8:
    case 9:
    case 10:
      guarded();
      break;
    case 11:
      retrying();
      break;
    default:
      asserting();
  }
  vars_.resize(vars);
  --nesting_;
}

void RandomProgram::body(int count) {
  const std::size_t vars = vars_.size();
  for (int i = 0; i < count; ++i) statement();
  vars_.resize(vars);
}

void RandomProgram::simple() {
  if (has_tasks_ && !in_lambda_ && one_in(8)) return waiting();
  switch (below(13)) {
    case 12:
      return map_statement();
    case 0:
    case 1:
      return declaration();
    case 2:
    case 3:
      return assignment();
    case 4:
    case 5:
      return compound();
    case 6:
    case 7:
      return place_assignment();
    case 8:
      return mutation();
    case 9:
      return aliasing();
    default:
      return show();
  }
}

void RandomProgram::declaration() {
  const std::string name = fresh();
  const Ty* type =
      one_in(6) ? function_type({one_in(2) ? int_ : real_}, one_in(2) ? int_ : real_) : storable();
  const bool can_change = !one_in(3);
  const bool is_classic = !type->is(Sort::kFunction) && one_in(4);
  if (type->is(Sort::kStruct) && one_in(4)) {
    std::string fields;
    for (const Field& field : structs_[type->id].fields)
      fields += field.name + ": " + loose(field.type, 1) + "; ";
    line(type->name + " " + name + " { " + fields + "}");
    vars_.push_back({name, type, false});
    return;
  }
  if (is_classic) {
    std::string all =
        (can_change ? "" : "final ") + type->name + " " + name + " = " + loose(type, 2);
    if (one_in(3)) {
      const std::string other = fresh();
      all += ", " + other + " = " + loose(type, 2);
      vars_.push_back({other, type, can_change});
    }
    line(all + ";");
  } else if (one_in(5) && can_change) {
    line("var " + name + ": " + type->name);
    line(name + " = " + loose(type, 2));
  } else if (one_in(3)) {
    line((can_change ? "var " : "let ") + name + ": " + type->name + " = " + loose(type, 2));
  } else {
    line((can_change ? "var " : "let ") + name + " = " + expr(type, 3));
  }
  vars_.push_back({name, type, can_change});
}

void RandomProgram::assignment() {
  const Ty* type = storable();
  const std::string to = place(type);
  if (to.empty()) return show();
  const std::string other = one_in(6) ? place(type) : "";
  line(to + (other.empty() ? "" : " = " + other) + " = " + loose(type, 3));
  if (type->is(Sort::kText)) keep_short(to);
}

// Texts that grow in a loop must not fill the machine.
void RandomProgram::keep_short(const std::string& name) {
  line("if (" + name + ".length > 40) { " + name + " = " + name + "[:9] }");
}

void RandomProgram::compound() {
  static const std::vector<std::string> kOps = {" += ", " -= ", " *= ", " /= "};
  static const std::vector<std::string> kSums = {" += ", " -= "};
  const Ty* type = one_in(3) ? real_ : one_in(4) ? storable() : int_;
  const std::string to = place(type);
  if (to.empty()) return show();
  if (type->is(Sort::kInt) && one_in(3)) {
    line(to + (one_in(2) ? "++" : "--"));
  } else if (type->is(Sort::kInt)) {
    line(to + (one_in(4) ? one_of(kOps) : one_of(kSums)) + integer(one_in(3) ? 2 : 0));
  } else if (type->is(Sort::kReal)) {
    line(to + one_of(kOps) + (one_in(4) ? integer(1) : real(2)));
  } else if (type->is_quantity()) {
    line(to + one_of(kSums) + expr(type, 2));
  } else if (type->is(Sort::kText)) {
    line(to + " += " + expr(one_in(2) ? text_ : scalar(), 2));
    keep_short(to);
  } else if (type->is_list_of(Sort::kInt) || type->is_list_of(Sort::kReal)) {
    line(to + one_of(kSums) + expr(type, 1));
  } else {
    line(to + " = " + expr(type, 2));
  }
}

// A variable of the type, or an element or field of one.
std::string RandomProgram::place(const Ty* type) {
  if (one_in(2)) {
    if (const Var* found = find(list_of(type), true)) {
      const std::string name = found->name;
      return name + "[" + index_of(name, 1) + "]";
    }
  }
  if (one_in(4)) {
    if (const Var* found = find_map(nullptr, type, true)) {
      const std::string name = found->name;
      return name + "[" + key_of(found->type, 1) + "]";
    }
  }
  if (one_in(2)) {
    for (const Struct& shape : structs_) {
      for (const Field& field : shape.fields) {
        if (field.type != type) continue;
        if (const Var* found = find(shape.type, true)) return found->name + "." + field.name;
        if (const Var* found = find(list_of(shape.type), true)) {
          const std::string name = found->name;
          return name + "[" + index_of(name, 1) + "]." + field.name;
        }
      }
    }
  }
  const Var* found = find(type, true);
  return found == nullptr ? "" : found->name;
}

// Elements of elements, fields of elements, elements of fields.
void RandomProgram::place_assignment() {
  if (has_grid_ && one_in(3)) return grid_assignment();
  static const std::vector<std::string> kOps = {" = ", " += ", " -= ", " *= "};
  if (const Var* rows = one_in(2) ? find(list_of(list_of(int_)), true) : nullptr) {
    const std::string name = rows->name;
    line(name + "[" + index_of(name, 2) + "][" + index(leaf(int_)) + "]" + one_of(kOps) +
         expr(int_, 2));
    return;
  }
  if (const Var* pile = one_in(2) ? find(list_of(real_), true) : nullptr) {
    const std::string name = pile->name;
    line(name + "[" + index_of(name, 2) + "]" + one_of(kOps) + (one_in(4) ? integer(1) : real(2)));
    return;
  }
  for (const Struct& shape : structs_) {
    const Field& field = one_of(shape.fields);
    const Var* found = one_in(2) ? find(list_of(shape.type), true) : nullptr;
    if (found != nullptr && field.type->is(Sort::kReal)) {
      const std::string name = found->name;
      line(name + "[" + index_of(name, 1) + "]." + field.name + " += " + real(0) + " * " + real(0));
      return;
    }
    if (found != nullptr && field.type->is_list_of(Sort::kInt)) {
      const std::string name = found->name;
      line(name + "[" + index_of(name, 1) + "]." + field.name + "[" + index(leaf(int_)) + "]" +
           one_of(kOps) + expr(int_, 2));
      return;
    }
  }
  assignment();
}

void RandomProgram::mutation() {
  const Var* found = find_list(true);
  if (found == nullptr) return show();
  const std::string name = found->name;
  const Ty* element = found->type->element;
  switch (below(5)) {
    case 0:
    case 1:
      line("if (" + name + ".length < 8) { " + name + ".push(" + loose(element, 2) + ") }");
      break;
    case 2:
      line("if (" + name + ".length < 8) { " + name + ".insert(" + index_of(name, 1) + ", " +
           loose(element, 2) + ") }");
      break;
    case 3:
      line(name + ".removeAt(" + index_of(name, 1) + ")");
      break;
    default:
      line("print(" + name + ".pop(), " + name + ")");
  }
}

// "1:3", ":2", ":"
std::string RandomProgram::stretch() {
  return (one_in(2) ? "" : std::to_string(below(2))) + ":" + (one_in(2) ? "" : index(leaf(int_)));
}

// Parts of the matrix, and of lists.
void RandomProgram::grid_assignment() {
  switch (below(6)) {
    case 0:
      return line("grid[" + index(leaf(int_)) + ", 1] = " + real(2));
    case 1:
      return line("grid[1, " + index(expr(int_, 1)) + "] += " + real(1));
    case 2:
      return line("grid[" + index(leaf(int_)) + ", :] = " + expr(list_of(real_), 2));
    case 3:
      return line("grid[" + stretch() + ", " + stretch() + "] = grid[" + stretch() + ", " +
                  stretch() + "]");
    case 4:
      return line("print(grid, grid * " + real(0) + ", grid[" + stretch() + ", 0])");
    default:
      break;
  }
  const Var* found = find_list(true);
  if (found == nullptr) return show();
  const std::string name = found->name;
  const Ty* type = found->type;
  // An end that the text shows, and a list that is written out, are compared before running.
  const std::string end = one_in(2) ? "" : "pile.length % " + std::to_string(2 + below(6));
  line(name + "[" + (one_in(2) ? "" : std::to_string(below(2))) + ":" + end +
       "] = " + expr(type, 2));
}

// Two names for one storage, until one of them is changed.
void RandomProgram::aliasing() {
  const Var* found = find_list(false);
  if (found == nullptr) return show();
  const std::string name = found->name;
  const Ty* type = found->type;
  const std::string copy = fresh();
  line("var " + copy + " = " + name);
  line(one_in(2)
           ? "if (" + copy + ".length > 0) { " + copy + "[0] = " + loose(type->element, 1) + " }"
           : copy + ".push(" + loose(type->element, 1) + ")");
  line("print(" + name + ", " + copy + ")");
  vars_.push_back({copy, type, true});
}

void RandomProgram::show() {
  if (one_in(4)) {
    line("System.out.println(" + expr(scalar(), 3) + ")");
    return;
  }
  std::string all;
  const std::size_t count = 1 + below(3);
  for (std::size_t i = 0; i < count; ++i)
    all += (i == 0 ? "" : ", ") + expr(one_in(3) ? storable() : scalar(), 3);
  line("print(" + all + ")");
}

}  // namespace armlet::oracle
