// Functions that copy a parameter, change the copy and give it back, and calls where the argument
// is needed afterwards or not: whoever still holds the old value must keep it.

#include "random/program.hpp"

namespace armlet::oracle {

void RandomProgram::declare_handing() {
  line("struct Crate { items: int[]; rows: int[][]; label: string }");
  line("var crate = Crate(items: [1, 2], rows: [[1], [2, 3]], label: \"c\")");
  line("var crateRows = crate.rows");
  open("fn putIn(h: int[], x: int) -> int[]");
  line("var r = h");
  if (one_in(3)) line("if (x > 6) { throw error(\"full\") }");
  line(one_in(2) ? "r.push(x)" : "r[0] = x");
  line("return " + std::string(one_in(4) ? "h" : "r"));
  close();
  open("fn putBoth(h: int[], x: int) -> int[]");
  line(one_in(2) ? "return putIn(putIn(h, x), h.length)"
                 : "let r = putIn(h, x)\nreturn putIn(r, h[0])");
  close();
  open("fn stretch(g: int[][], x: int) -> int[][]");
  line(one_in(2) ? "var r = g" : "var r: int[][] = []\nr = g");
  line("r[0].push(x)");
  line("r.push(putIn(r[0], x))");
  if (one_in(3)) line("if (r.length > 4) { r[9] = r[0] }");
  line("return r");
  close();
  open("fn stamp(c: Crate, x: int) -> Crate");
  line("var d = c");
  line("d.items = putIn(d.items, x)");
  line("d.rows = stretch(d.rows, x)");
  line("d.label += \"x\"");
  line("return d");
  close();
  open("fn handing(list: int[], grid: int[][], n: int) -> int");
  line("var a = list\nvar b = [n, 7]\nvar g = grid\nvar old = g\nvar c = crate\nvar s = \"s\"");
  const std::size_t count = 4 + below(6);
  for (std::size_t i = 0; i < count; ++i) handing_statement();
  line("print(a, b, g, old, c, s, list, grid)");
  line("return a.length + b.length");
  close();
  line("for (n in range(4)) {\ntry { print(handing([n, 5], [[n], [2]], n)) }");
  line("catch (e) { print(e.kind, e.message, e.line) }\n}");
  line("print(crate, crateRows)");
}

std::string RandomProgram::handing_call() {
  static const std::vector<std::string> kCalls = {
      "putIn(a, n)",           "putIn(b, a.length)", "putIn(a, a[0])",   "putBoth(a, n)",
      "putIn(putIn(b, 1), 2)", "putIn([1, n], 3)",   "putBoth(b, b[1])", "putIn(g[0], n)",
      "putIn(c.items, n)",     "putIn(list, n)",     "putIn(old[0], 4)"};
  return one_of(kCalls);
}

void RandomProgram::handing_statement() {
  static const std::vector<std::string> kLists = {"a", "b", "a", "b", "g[0]", "c.items"};
  const std::string name = fresh();
  switch (below(14)) {
    case 0:
    case 1:
    case 2:
      return line(one_of(kLists) + " = " + handing_call());
    case 3:
      return line("g = stretch(g, n)" + std::string(one_in(2) ? "\nold = g" : ""));
    case 4:
      return line("let " + name + " = " + handing_call() + "\nb = " + name);
    case 5:
      return line("for (i in range(3)) { " + std::string(one_in(2) ? "a" : "b") + " = " +
                  handing_call() + (one_in(3) ? "\nif (i == n) { break }" : "") + " }");
    case 6:
      return line("try { a = putIn(a, n + 6) } catch (e) { print(a, e.message) }");
    case 7:
      return line("c = stamp(c, n)" + std::string(one_in(2) ? "\ncrate = c" : ""));
    case 8:
      return line("for (x in a) { let " + name + " = a\na = putIn(" + name + ", x)\n" +
                  (one_in(2) ? "print(x)\nbreak" : "if (a.length > 6) { break }") + " }");
    case 9:
      return line("let " + name + " = a\na = b\nb = " + name);
    case 10:
      return line("for (r in g) { var " + name + " = g\n" + name + "[0] = [9]\nprint(r, " + name +
                  ")\nif (n > 1) { break } }");
    case 11:
      return line("let " + name + " = putIn(a, " + (one_in(2) ? "a.length" : "putIn(a, 1).length") +
                  ")\nprint(" + name + (one_in(2) ? ", a)" : ")"));
    case 12:
      return line("s = s + \"t\"\nvar " + name + " = s\n" + name + " += \"u\"\nprint(" + name +
                  ")");
    default:
      return line("if (n > 1) { b = putIn(a, n) } else { a = putIn(b, n) }");
  }
}

}  // namespace armlet::oracle
