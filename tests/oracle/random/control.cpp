// Statements that decide where to go on.

#include <utility>

#include "random/program.hpp"

namespace armlet::oracle {

void RandomProgram::conditional() {
  open("if (" + truth(2) + ")");
  body(1 + static_cast<int>(below(2)));
  leaving();
  if (one_in(3)) {
    close(" else if (" + truth(1) + ") {");
    body(1);
  }
  if (one_in(2)) {
    close(" else {");
    body(1);
  }
  close();
}

// An exit from what is open.
void RandomProgram::leaving() {
  if (loops_ > 0 && !in_lambda_ && one_in(4)) {
    line("if (" + truth(1) + ") { " + (one_in(2) ? "break" : "continue") + " }");
  } else if (result_ != nullptr && one_in(4)) {
    returning();
  } else if (one_in(6)) {
    line("if (" + truth(0) + ") { throw error(" + expr(text_, 1) + ", kind: \"" +
         (one_in(3)   ? "Timeout"
          : one_in(2) ? "Overflow"
                      : "Mine") +
         "\") }");
  }
}

void RandomProgram::returning() {
  line("if (" + truth(1) + ") { return " + loose(result_, 1) + " }");
}

// Statements of a loop that counts in `counter`, an int.
void RandomProgram::loop_body(const std::string& counter) {
  ++loops_;
  vars_.push_back({counter, int_, false});
  body(1 + static_cast<int>(below(2)));
  leaving();
  vars_.pop_back();
  --loops_;
}

void RandomProgram::counted() {
  const std::string name = fresh();
  const std::string bound = one_in(3)   ? "4"
                            : one_in(2) ? "pile.length"
                                        : "abs(" + leaf(int_) + " % 5)";
  if (one_in(3)) {
    open("for (int " + name + " = 3; " + name + " >= 0; " + name + (one_in(2) ? "--)" : " -= 2)"));
  } else if (one_in(4)) {
    const std::string down = fresh();
    open("for (int " + name + " = 0, " + down + " = " + bound + "; " + name + " < " + down + "; " +
         name + "++, " + down + "--)");
    if (one_in(2)) line("print(" + name + ", " + down + ")");
  } else if (one_in(3)) {
    open("for (int " + name + " = 0; " + name + " <= 4; " + name +
         " += " + std::to_string(1 + below(3)) + ")");
  } else {
    open("for (int " + name + " = 0; " + name + " < " + bound + "; " + name + "++)");
  }
  loop_body(name);
  close();
}

void RandomProgram::ranged() {
  const std::string name = fresh();
  std::string bounds = std::to_string(1 + below(4));
  if (one_in(3)) bounds = "abs(" + expr(int_, 1) + " % 4)";
  if (one_in(3)) bounds = leaf(int_) + " % 3, 3";
  if (one_in(4)) bounds = std::to_string(below(3)) + ", 8, 3";
  if (one_in(4)) bounds = "5, -1, -2";
  if (one_in(5)) bounds = "6, 0, -1 - " + std::to_string(below(3));
  if (one_in(12)) bounds = "9223372036854775800, 9223372036854775807, 5";
  if (one_in(8)) bounds = "0, 4, " + leaf(int_) + " % 3 + 2";
  if (one_in(20)) bounds = "3, 0, " + leaf(int_) + " % 1";
  open("for (" + name + " in range(" + bounds + "))");
  loop_body(name);
  close();
}

void RandomProgram::visiting() {
  const bool letters = one_in(8);
  const Ty* element = letters ? text_ : one_in(3) ? storable() : scalar();
  const Ty* type = letters ? text_ : list_of(element);
  const std::string name = fresh();
  const std::string index = one_in(3) ? fresh() : "";
  const Var* found = find(type);
  const std::string items = found != nullptr && !one_in(3) ? found->name : expr(type, 2);
  if (!index.empty()) {
    open("for (" + index + ", " + name + " in " + items + ")");
    vars_.push_back({index, int_, false});
  } else if (element->is(Sort::kReal) && one_in(3)) {
    open("for (double " + name + " : " + items + ")");
  } else {
    open("for (" + name + " in " + items + ")");
  }
  ++loops_;
  vars_.push_back({name, element, false});
  body(1 + static_cast<int>(below(2)));
  leaving();
  vars_.pop_back();
  if (!index.empty()) vars_.pop_back();
  --loops_;
  close();
}

// while and do, with a counter that ends them.
void RandomProgram::repeating() {
  const std::string name = fresh();
  line("var " + name + " = 0");
  const bool tests_first = one_in(2);
  const std::string condition =
      name + " < " + std::to_string(1 + below(4)) + (one_in(2) ? " && " + truth(1) : "");
  open(tests_first ? "while (" + condition + ")" : "do");
  line(name + (one_in(2) ? "++" : " += 1"));
  loop_body(name);
  close(tests_first ? "" : " while (" + condition + ")");
}

void RandomProgram::choosing() {
  const std::size_t kind = below(3);
  const Ty* type = kind == 0 || enums_.empty() ? (kind == 1 ? text_ : int_) : enums_[0];
  std::vector<std::string> cases = {"0", "1", "2", "3"};
  if (type == text_) cases = {"\"a\"", "\"12\"", "\"\"", "\"Zz top\""};
  if (type->is(Sort::kEnum)) {
    cases.clear();
    for (const std::string& value : enum_values_[type->id])
      cases.push_back(type->name + "." + value);
  }
  open("switch (" + expr(type, 2) + ")");
  const bool all = type->is(Sort::kEnum) && one_in(2);
  const std::size_t count = all ? cases.size() : 1 + below(cases.size());
  const int loops = loops_;
  for (std::size_t i = 0; i < count; ++i) {
    const bool two = i + 1 < count && one_in(4);
    line("case " + cases[i] + (two ? ", " + cases[i + 1] : "") + ":");
    if (two) ++i;
    body(1);
    if (one_in(3)) line(one_in(2) ? "break" : "if (" + truth(0) + ") { break }");
  }
  loops_ = loops;
  if (!all || one_in(3)) {
    line("default:");
    body(1);
  }
  close();
}

void RandomProgram::guarded() {
  open("try");
  body(1 + static_cast<int>(below(2)));
  leaving();
  const std::string name = fresh();
  const bool catches = !one_in(5);
  if (catches) {
    close(one_in(6) ? " catch {" : " catch (" + name + ") {");
    const bool named =
        out_.ends_with(") {\n") || out_.rfind("(" + name + ") {") != std::string::npos;
    if (named) {
      line("print(" + name + ".kind, " + name + ".message, " + name + ".line)");
      if (one_in(5)) line("if (" + truth(0) + ") { throw " + name + " }");
    }
    body(1);
    if (one_in(3)) leaving();
  }
  if (!catches || one_in(3)) {
    close(" finally {");
    // It may not be left otherwise than by an error.
    const auto result = std::exchange(result_, nullptr);
    const auto loops = std::exchange(loops_, 0);
    body(1);
    if (one_in(4)) leaving();
    result_ = result;
    loops_ = loops;
  }
  close();
}

void RandomProgram::retrying() {
  const std::string name = fresh();
  const std::string error = fresh();
  line("var " + name + " = 0");
  open("try");
  line(name + "++");
  vars_.push_back({name, int_, false});
  body(1);
  line("if (" + name + " < " + std::to_string(1 + below(4)) + ") { throw error(\"again \" + " +
       name + ") }");
  close(" catch (" + error + ") {");
  line("print(" + error + ".message, " + error + ".line)");
  line("if (" + name + " < 4) { retry }");
  close(one_in(3) ? " finally { print(\"end\", " + name + ") }" : "");
  vars_.pop_back();
}

void RandomProgram::asserting() {
  if (one_in(2)) {
    line("try { assert(" + truth(2) + ", " + expr(text_, 1) + ") } catch { print(\"not so\") }");
  } else if (one_in(3)) {
    line("assertThrows(fn() => abs(" + integer(1) + ")" +
         (one_in(2) ? ", kind: \"Overflow\")" : ")"));
  } else {
    open("try");
    line("assert(" + truth(1) + ")");
    body(1);
    close(" catch (" + fresh() + ") {");
    line("print(\"caught\", " + leaf(int_) + ")");
    close();
  }
}

}  // namespace armlet::oracle
