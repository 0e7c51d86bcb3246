#pragma once
// Writes random programs that pass the checker: numbers, lists, records, functions, loops, failures
// and their handling.

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace armlet::lang {

class RandomProgram {
 public:
  explicit RandomProgram(std::uint64_t seed) : random_(std::mt19937_64(seed)) {}
  // Choices taken from elsewhere.
  explicit RandomProgram(std::function<std::uint64_t()> random) : random_(std::move(random)) {}

  std::string text() {
    std::string out =
        "struct P { x: double; n: int; xs: double[] }\n"
        "var gi = 3\nvar gd = 1.5\nvar gl = [1.0, 2.0, 3.0]\nvar gm = [[1, 2], [3, 4, 5]]\n"
        "var gp = [P(x: 0.5, n: 1, xs: [1.0]), P(x: 2.5, n: 2, xs: [2.0, 3.0])]\nvar gs = \"s\"\n";
    for (leaves_ = 0; leaves_ < 4;) out += leaf();
    for (functions_ = 0; functions_ < 3; ++functions_) out += function();
    in_function_ = false;
    recent_.clear();
    ints_ = {"gi"};
    reals_ = {"gd"};
    lists_ = {"gl"};
    for (int i = 0; i < 8; ++i) out += statement(2);
    return out + "print(gi, gd, gl, gm, gp, gs)\n";
  }

 private:
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
  template <class T>
  const T& one_of(const std::vector<T>& items) {
    return items[below(items.size())];
  }
  std::string fresh() { return "v" + std::to_string(++names_); }

  // A small function that calls none, of ints or of doubles by turns.
  std::string leaf() {
    const bool whole = leaves_ % 2 == 0;
    recent_.clear();
    ints_ = {"gi", "a"};
    reals_ = {"gd", "b"};
    lists_ = {"gl", "c"};
    calls_ = false;
    std::string out = "fn g" + std::to_string(leaves_) + "(a: int, b: double, c: double[]) -> " +
                      (whole ? "int" : "double") + " {\n";
    const auto result = [&](int depth) { return whole ? integer(depth) : real(depth); };
    if (below(2) == 0) {
      out += std::string("var t = ") + result(1) + "\n";
      if (below(2) == 0) out += "if (" + truth(1) + ") { t += " + result(1) + " }\n";
      (whole ? ints_ : reals_).push_back("t");
    }
    if (below(3) == 0) out += "if (" + truth(1) + ") { return " + result(1) + " }\n";
    if (below(3) == 0) {
      out += "if (" + truth(1) + ") { return " + result(1) + " } else { return " + result(1) +
             " }\n}\n";
    } else {
      out += "return " + result(2) + "\n}\n";
    }
    ++leaves_;
    calls_ = true;
    return out;
  }

  std::string function() {
    in_function_ = true;
    recent_.clear();
    ints_ = {"gi", "a"};
    reals_ = {"gd", "b"};
    lists_ = {"gl"};
    std::string out =
        "fn f" + std::to_string(functions_) + "(a: int, b: double, c: double[]) -> double {\n";
    for (int i = 0; i < 4; ++i) out += statement(2);
    return out + "return " + real(3) + "\n}\n";
  }

  // ---- expressions
  std::string integer(int depth) {
    if (depth == 0 || below(4) == 0) {
      return below(3) == 0 ? std::to_string(below(5)) : one_of(ints_);
    }
    const std::string a = integer(depth - 1);
    const std::string b = integer(depth - 1);
    switch (below(9)) {
      case 0:
        return call_leaf(0, a, b);
      case 1:
        return "(" + a + " + " + b + ")";
      case 2:
        return "(" + a + " - " + b + ")";
      case 3:
        return "(" + a + " * " + b + ") % 1000";
      case 4:
        return a + " / (" + b + ")";
      case 5:
        return "gm[" + integer(1) + " % 2][" + b + " % 2]";
      case 6:
        return "(" + truth(depth - 1) + " ? " + a + " : " + b + ")";
      default:
        return one_of(lists_) + ".length";
    }
  }

  std::string call_leaf(std::size_t kind, const std::string& whole, const std::string& number) {
    if (!calls_) return kind == 0 ? "-(" + whole + ")" : number + " / 2.0";
    return "g" + std::to_string(kind + 2 * below(2)) + "(" + whole + ", " + number + ", " +
           one_of(lists_) + ")";
  }

  // Often the same expression again.
  std::string real(int depth) {
    if (!recent_.empty() && below(5) == 0) return one_of(recent_);
    std::string made = new_real(depth);
    if (depth > 0) recent_.push_back(made);
    if (recent_.size() > 4) recent_.erase(recent_.begin());
    return made;
  }

  std::string new_real(int depth) {
    if (depth == 0 || below(4) == 0) {
      return below(3) == 0 ? std::to_string(below(5)) + ".25" : one_of(reals_);
    }
    const std::string a = real(depth - 1);
    const std::string b = real(depth - 1);
    switch (below(14)) {
      case 11:
        return call_leaf(1, integer(1), a);
      case 12:
        return "(" + integer(1) + " * " + one_of(reals_) + " - " + a + ")";
      case 13:
        return "(" + one_of(reals_) + " - gp[" + integer(1) + " % 2].x)";
      case 0:
        return a + " * " + b + " + " + real(depth - 1);
      case 1:
        return a + " + " + b + " * " + real(depth - 1);
      case 2:
        return "(" + a + " - " + b + " * " + b + ")";
      case 3:
        return "(" + a + " * " + b + ") / (1.5 + " + integer(1) + ")";
      case 4:
        return one_of(lists_) + "[" + integer(2) + " % 3]";
      case 5:
        return "gp[" + integer(1) + " % 2].x";
      case 6:
        return "gp[1].xs[" + integer(1) + " % 2] * " + a;
      case 7:
        return "(" + truth(depth - 1) + " ? " + a + " : " + b + ")";
      case 8:
        return "(" + integer(depth - 1) + ") * " + b;
      case 9:
        return "hypot(" + a + ", " + b + ")";
      default:
        if (functions_ == 0 || !calls_) return "-(" + a + ")";
        return "f" + std::to_string(below(static_cast<std::size_t>(functions_))) + "(" +
               integer(1) + ", " + a + ", " + one_of(lists_) + ")";
    }
  }

  std::string truth(int depth) {
    static const std::vector<std::string> kCompare = {" < ", " <= ", " > ", " >= ", " == ", " != "};
    if (depth == 0 || below(3) == 0) {
      return below(2) == 0 ? integer(1) + one_of(kCompare) + integer(1)
                           : real(1) + one_of(kCompare) + real(1);
    }
    switch (below(3)) {
      case 0:
        return "(" + truth(depth - 1) + " && " + truth(depth - 1) + ")";
      case 1:
        return "(" + truth(depth - 1) + " || " + truth(depth - 1) + ")";
      default:
        return "!(" + truth(depth - 1) + ")";
    }
  }

  // ---- statements
  std::string statement(int depth) {
    switch (below(depth == 0 ? 10 : 15)) {
      case 0:
        return "gi = " + integer(3) + "\n";
      case 1:
        return "gd = " + real(3) + "\n";
      case 2:
        return "gd += " + real(1) + " * " +
               (below(2) == 0 ? real(1) : "gl[" + integer(1) + " % 3]") + "\n";
      case 3:
        return "gl[" + integer(1) + " % 3] " + one_of(kAssign_) + " " + real(2) + "\n";
      case 4:
        return "gm[" + integer(1) + " % 2][" + integer(1) + " % 2] = " + integer(2) + "\n";
      case 5:
        return "gp[" + integer(1) + " % 2].x " + one_of(kAssign_) + " " + real(1) + " * " +
               real(1) + "\n";
      case 6:
        return "gp[" + integer(1) + " % 2].xs[0] = " + real(2) + "\n";
      case 7:
        return "gs = gs + " + integer(1) + " + \",\"\n";
      case 8:
        return "print(" + integer(2) + ", " + real(2) + ", " + truth(1) + ")\n";
      case 9:
        return declaration();
      case 10:
        return "if (" + truth(2) + ") {\n" + body(depth) + "} else {\n" + body(depth) + "}\n";
      case 11:
        return counted(depth);
      case 12:
        return visiting(depth);
      case 13:
        return guarded(depth);
      default:
        return in_function_ ? "if (" + truth(1) + ") { return " + real(2) + " }\n" : counted(depth);
    }
  }

  std::string declaration() {
    const std::string name = fresh();
    switch (below(3)) {
      case 0:
        return "var " + name + " = " + integer(3) + "\n" + name + " += " + integer(1) +
               "\ngi = " + name + " % 50\n";
      case 1:
        return "let " + name + " = " + real(3) + "\ngd = " + name + " * " + name + " - gd\n";
      default:
        return "var " + name + " = " + one_of(lists_) + "\n" + name + "[0] = " + real(1) + "\n" +
               name + ".push(gd)\ngd -= " + name + "[" + name + ".length - 1] * " + name +
               ".pop()\n";
    }
  }

  // Names declared in a body end with it.
  std::string body(int depth) {
    std::string out;
    for (int i = 0; i < 2; ++i) out += statement(depth - 1);
    return out;
  }

  std::string leaving() {
    return below(3) == 0
               ? "if (" + truth(1) + ") { " + (below(2) == 0 ? "break" : "continue") + " }\n"
               : "";
  }

  std::string counted(int depth) {
    static const std::vector<std::string> kHeads = {
        "for (int @ = 0; @ < 4; @++)", "for (int @ = 3; @ >= 0; @--)",
        "for (@ in range(gl.length))", "for (@ in range(1, 9, 3))",
        "for (int @ = 0; @ < gl.length; @++)"};
    const std::string name = fresh();
    std::string head = one_of(kHeads);
    for (std::size_t at = head.find('@'); at != std::string::npos; at = head.find('@'))
      head.replace(at, 1, name);
    ints_.push_back(name);
    std::string out = head + " {\n" + leaving() + body(depth) + "}\n";
    ints_.pop_back();
    recent_.clear();
    return out;
  }

  std::string visiting(int depth) {
    const std::string name = fresh();
    const std::string list = one_of(lists_);
    reals_.push_back(name);
    std::string out = "for (" + name + " in " + list + ") {\n" + leaving() + body(depth) + "}\n";
    reals_.pop_back();
    recent_.clear();
    return out;
  }

  std::string guarded(int depth) {
    const std::string name = fresh();
    std::string out = "try {\n" + body(depth) + "if (" + truth(1) +
                      ") { throw error(\"e\" + gi) }\n} catch (" + name + ") {\nprint(" + name +
                      ".message)\n" + body(depth) + "}";
    if (below(2) == 0) out += " finally {\n" + body(depth - 1 > 0 ? 1 : depth) + "}";
    return out + "\n";
  }

  std::function<std::uint64_t()> random_;
  std::vector<std::string> kAssign_ = {"=", "+=", "-=", "*="};
  std::vector<std::string> ints_;
  std::vector<std::string> reals_;
  std::vector<std::string> lists_;
  std::vector<std::string> recent_;  // good where they are now
  int functions_ = 0;
  int leaves_ = 0;
  bool calls_ = true;
  int names_ = 0;
  bool in_function_ = false;
};

}  // namespace armlet::lang
