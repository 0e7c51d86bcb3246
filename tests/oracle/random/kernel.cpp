// Loops that compute with doubles: long expressions of few variables, sums that grow from pass to
// pass, elements and fields among them.

#include "random/program.hpp"

namespace armlet::oracle {

void RandomProgram::declare_kernel() {
  line("struct Mass { x: double; v: double; m: double }");
  line("var masses = [Mass(x: 0.5, v: -1.5, m: 2), Mass(x: 3, v: 0.25, m: 0.1),");
  line("    Mass(x: -1, v: 1, m: 1)]");
  if (one_in(2)) line("let shared = masses");
  open("fn kernel(a: double, b: double, k: int, xs: double[], rows: double[][]) -> double");
  line("var own = masses");
  line("var p = a");
  line("var q = " + kernel_term(1, "k"));
  const bool nested = one_in(3);
  if (nested) open("for (i in range(2))");
  if (one_in(2)) line("p = " + literal(real_));
  kernel_loop();
  if (nested) close();
  if (one_in(3)) line("p -= q + own[0].v");
  line("return " + (one_in(2) ? "p" : kernel_term(2, "k")));
  close();
  open("fn ramp(n: int, x: double) -> double");
  line("if (n <= 0) { return x * " + literal(real_) + " + " + literal(real_) + " }");
  line("return ramp(n - 1, x * " + literal(real_) + " - n) + " + literal(real_));
  close();
  open("for (n in range(3))");
  line("try { print(kernel(n / 2.0, " + literal(real_) + ", n, [1.5, 2, " + literal(real_) +
       ", 4], [[1, 2, 3], [4, " + literal(real_) + ", 6], [7.5, 8, 9]]), ramp(n, " +
       literal(real_) + ")) }");
  line("catch (e) { print(e.kind, e.message, e.line) }");
  close();
  line("print(masses)");
}

void RandomProgram::kernel_loop() {
  static const std::vector<std::string> kLoops = {
      "for (j in range(3))", "for (int j = 0; j < xs.length; j++)", "for (int j = k; j < 3; j++)",
      "for (j in range(2, -1, -1))"};
  const bool is_while = one_in(3);
  if (is_while) line("var j = 0");
  open(is_while ? "while (j < 3 && p * p + q * q <= " + literal(real_) + " + 1e9)"
                : one_of(kLoops));
  const std::size_t count = 1 + below(5);
  for (std::size_t i = 0; i < count; ++i) kernel_statement();
  if (one_in(4)) line(one_in(2) ? "if (p > q) { break }" : "if (p > q) { p = q - p }");
  if (is_while) line("j++");
  close();
}

void RandomProgram::kernel_statement() {
  static const std::vector<std::string> kSums = {" += ", " -= ", " *= "};
  const std::string to = one_in(3) ? "q" : "p";
  switch (below(9)) {
    case 0: {
      const std::string name = fresh();
      line("let " + name + " = " + kernel_term(3, "j"));
      line(to + " = " + name + one_of(kSums).substr(0, 2) + " " + kernel_term(1, "j"));
      return;
    }
    case 1:
      return line(to + one_of(kSums) + kernel_term(0, "j") + " * " + kernel_term(1, "j"));
    case 2:
      return line("masses[j].v += " + kernel_term(0, "j") + " * " + kernel_term(0, "j"));
    case 3:
      return line("masses[j].x = " + kernel_term(2, "j"));
    case 4:
      return line(to + " += " + kernel_term(0, "j") + " * rows[j][k]");
    case 5:
      return line(to + " += xs[j] * " + (one_in(2) ? "xs[k]" : "rows[j][k]"));
    case 6:
      return kernel_fields();
    default:
      return line(to + (one_in(2) ? " = " : one_of(kSums)) + kernel_term(3, "j"));
  }
}

// Several fields of one element, read or changed one after the other.
void RandomProgram::kernel_fields() {
  const std::string element =
      std::string(one_in(3) ? "own" : "masses") + (one_in(3) ? "[k]" : "[j]");
  if (one_in(2)) {
    const std::string name = fresh();
    line("let " + name + " = p - " + element + ".x");
    line("q = (" + name + " + " + element + ".v) * " + element + ".m");
    return;
  }
  static const std::vector<std::string> kFields = {"x", "v", "m"};
  const std::size_t count = 2 + below(2);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string place = element + "." + one_of(kFields);
    line(place + (one_in(2) ? " += " + kernel_term(0, "j") + " * " + kernel_term(0, "j")
                            : " = " + kernel_term(1, "j")));
  }
}

std::string RandomProgram::kernel_term(int depth, const std::string& index) {
  if (depth <= 0 || one_in(8)) {
    static const std::vector<std::string> kFields = {"x", "v", "m"};
    switch (below(11)) {
      case 0:
        return literal(real_);
      case 1:
        return "xs[" + index + "]";
      case 2:
        return "masses[" + index + "]." + one_of(kFields);
      case 3:
        return "rows[" + index + "][k]";
      case 4:
      case 5:
        return one_in(2) ? "a" : "b";
      default:
        return one_in(2) ? "p" : (index == "k" ? "a" : "q");
    }
  }
  const std::string left = kernel_term(depth - 1, index);
  const std::string right = kernel_term(depth - (one_in(2) ? 1 : 2), index);
  switch (below(14)) {
    case 0:
      return "sqrt(" + left + ")";
    case 1:
      return "(" + left + (one_in(2) ? " * " : " - ") + index + ")";
    case 2:
      return "(" + index + (one_in(2) ? " * " : " + ") + left + ")";
    case 3:
      return "(" + right + " / " + left + ")";
    case 4:
      return "(" + left + " / " + right + ")";
    case 5:
    case 6:
      return "(" + left + " - " + right + ")";
    case 7:
    case 8:
      return "(" + left + " + " + right + ")";
    case 9:
      return "(" + left + " * " + right + " - " + kernel_term(0, index) + " * " +
             kernel_term(0, index) + ")";
    case 10:
      return "(" + right + " - " + left + ")";
    default:
      return "(" + left + " * " + right + ")";
  }
}

}  // namespace armlet::oracle
