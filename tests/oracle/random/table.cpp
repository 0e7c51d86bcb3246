// Loops over lists of ints and doubles that are changed: exchanges, counts, copies, neighbours,
// rows, and the ifs that choose one of two numbers.

#include "random/program.hpp"

namespace armlet::oracle {

void RandomProgram::declare_table() {
  line("struct Shelf { counts: int[]; weights: double[] }");
  line("var shelf = Shelf(counts: [1, 2, 3, 4], weights: [0.5, -1, 2, 8])");
  open("fn table(n: int, k: int, list: int[], reals: double[], grid: int[][]) -> int");
  line("var own = list");
  line("var other = " + std::string(one_in(2) ? "own" : "[4, 3, 2, 1]"));
  line("var xs = reals");
  line("var rows = grid");
  line("var cells = [xs, [1.5, 2.5, 3.5, 4.5], xs]");
  line("var s = " + (one_in(4) ? literal(int_) : "n - 2"));
  line("var t = k");
  line("var x = xs[0]");
  line("var y = 1.5");
  const std::size_t count = 1 + below(3);
  for (std::size_t i = 0; i < count; ++i) table_loop();
  line("print(own, other, xs, rows, cells, shelf, x, y)");
  line("return s + t");
  close();
  open("for (n in range(4))");
  line("try { print(table(n, " + std::string(one_in(3) ? "n - 1" : "1") + ", [3, 1, n, " +
       literal(int_) + "], [1, 2.5, " + literal(real_) +
       ", -1], [[1, 2, 3], [4, 5, 6], [n, 8, 9]])) }");
  line("catch (e) { print(e.kind, e.message, e.line) }");
  close();
  line("print(shelf)");
}

void RandomProgram::table_loop() {
  static const std::vector<std::string> kLoops = {"for (i in range(3))",
                                                  "for (int i = 0; i < n; i++)",
                                                  "for (int i = 0; i <= n; i++)",
                                                  "for (int i = 0; i < n; i += 2)",
                                                  "for (int i = 0; i < 3; i += 2)",
                                                  "for (int i = 0; i <= 2; i++)",
                                                  "for (int i = 3; i > 0; i--)",
                                                  "for (int i = 3; i >= 0; i--)",
                                                  "for (int i = n; i > k; i--)",
                                                  "for (int i = n; i >= k; i -= 2)",
                                                  "for (int i = k; n > i; i += 3)"};
  const bool meets = one_in(5);
  if (meets) {
    open("if (n >= 0)");
    line("var i = " + table_index("k"));
    line("var j = 3");
    open(one_in(2) ? "while (i < j)" : "while (j >= i && s < 1000)");
  } else {
    open(one_of(kLoops));
    line("let j = " + table_index("i"));
  }
  const std::size_t count = 1 + below(4);
  for (std::size_t i = 0; i < count; ++i) table_statement();
  if (meets) {
    line(one_in(2) ? "i++\nj--" : "j -= 1\ni += 1");
    close();
  }
  close();
  if (one_in(4)) line("while (t >= 2) { t = t / " + std::string(one_in(2) ? "2" : "3") + " }");
  if (one_in(6)) line("while (s > 9) { s = s - s / 8 - 1 }");
}

std::string RandomProgram::table_index(const std::string& base) {
  static const std::vector<std::string> kOffsets = {"", "", "", " + 1", " - 1", " + k"};
  return base + one_of(kOffsets);
}

std::string RandomProgram::table_int() {
  static const std::vector<std::string> kTerms = {
      "s",        "t",         "i",         "k",     "n",      "own[i]",         "own[j]",
      "other[i]", "s * 3 + 1", "2 * t + 1", "t % 4", "s / 8",  "own[i + 1]",     "rows[i][j]",
      "s % 1024", "i - 1",     "-7 / 4",    "t * 5", "-s % 2", "shelf.counts[i]"};
  return one_of(kTerms);
}

std::string RandomProgram::table_real() {
  static const std::vector<std::string> kTerms = {
      "x", "y", "xs[i]", "xs[j]", "x * y", "0.5", "xs[i + 1]", "cells[i][j]", "shelf.weights[j]"};
  return one_of(kTerms);
}

void RandomProgram::table_choice() {
  static const std::vector<std::string> kComparisons = {" < ",  " <= ", " > ",
                                                        " >= ", " == ", " != "};
  static const std::vector<std::string> kRealChoices = {"x = y", "y = x", "s += 1", "t -= 2",
                                                        "x = 0.5"};
  static const std::vector<std::string> kIntChoices = {"s = t",  "t = i",      "s += 1",
                                                       "t -= 1", "s = own[j]", "t = 3"};
  const std::string relation = one_of(kComparisons);
  const bool is_real = one_in(3);
  const std::string test =
      is_real ? table_real() + relation + table_real() : table_int() + relation + table_int();
  const std::string choice = one_of(is_real ? kRealChoices : kIntChoices);
  if (one_in(4)) {
    line("t += " + std::to_string(below(5)) + "\nif (t" + relation + (one_in(2) ? "n" : "2") +
         ") { s = s - 1\nx += 1 }");
  } else {
    line("if (" + test + ") " + choice + (one_in(5) ? "\nelse t = s" : ""));
  }
}

void RandomProgram::table_statement() {
  static const std::vector<std::string> kChanges = {" += ", " -= ", " *= ", " = "};
  static const std::vector<std::string> kIntLists = {"own",          "own",     "other",
                                                     "shelf.counts", "rows[k]", "rows[i]"};
  static const std::vector<std::string> kRealLists = {"xs",       "xs",       "shelf.weights",
                                                      "cells[0]", "cells[k]", "cells[i]"};
  const std::string index = table_index(one_in(3) ? "j" : "i");
  switch (below(12)) {
    case 0:
      return line(one_of(kIntLists) + "[" + index + "]" + one_of(kChanges) + table_int());
    case 1:
      return line(one_of(kIntLists) + "[" + index + "]" + (one_in(2) ? "++" : " -= 3"));
    case 2: {
      const std::string spare = fresh();
      const std::string list = one_of(kIntLists);
      return line("let " + spare + " = " + list + "[i]\n" + list + "[i] = " + list + "[j]\n" +
                  list + "[j] = " + spare);
    }
    case 3:
      return line("own[" + index + "] = other[" + table_index("i") + "]");
    case 4:
    case 5:
    case 6:
      return table_choice();
    case 7:
      return line(one_of(kRealLists) + "[" + index + "]" + one_of(kChanges) + table_real());
    case 8:
      return line(one_of(kRealLists) + "[" + index + "]" + (one_in(2) ? " += " : " -= ") + "x * " +
                  (one_in(2) ? "y" : "cells[k][i]"));
    case 9:
      return line(std::string(one_in(2) ? "s" : "t") + " = " + table_int());
    case 10:
      return line("x" + one_of(kChanges) + table_real());
    default:
      return line("s = 3 * " + std::string(one_in(2) ? "t" : "i") + " + " +
                  std::to_string(below(9)));
  }
}

}  // namespace armlet::oracle
