// Operations whose operands are elements of lists, of rows and of variables of the program, tests
// whether a number can be divided, characters, switches, and loops of one statement.

#include "random/program.hpp"

namespace armlet::oracle {

void RandomProgram::declare_operands() {
  line("var tally = [3, 1, 4, 1, 5]\nvar levels = [0.5, 2, -1.5]");
  open("fn operands(n: int, k: int, xs: int[], ys: double[], word: string, grid: int[][]) -> int");
  line("var own = xs\nvar zs = ys\nvar ws = [1.5, -2, 0.25, 3]\nvar rows = [ys, ws, zs, ws]");
  line("var g = grid\nvar s = n\nvar t = k + 4\nvar x = 0.5\nvar y = 1.5\nvar j = 0");
  line("let step = n + 1");
  const std::size_t count = 5 + below(6);
  for (std::size_t i = 0; i < count; ++i) operand_statement();
  line("print(own, zs, rows, g, s, t, x, y, j, tally, levels)");
  line("return s + t");
  close();
  line("for (n in range(4)) {\ntry { print(operands(n, " + std::string(one_in(3) ? "n - 1" : "2") +
       ", [3, n, 2, " + literal(int_) + "], [1, 2.5, " + literal(real_) + ", -1], \"a" +
       (one_in(2) ? "b" : "é") + "cab\", [[1, 2, 3], [4, n, 6], [7, 8, 9]])) }");
  line("catch (e) { print(e.kind, e.message, e.line) }\n}\nprint(tally, levels)");
}

std::string RandomProgram::operand_relation() {
  static const std::vector<std::string> kRelations = {" < ", " <= ", " > ", " >= ", " == ", " != "};
  return one_of(kRelations);
}

// A comparison with an element, by itself or of a loop that goes on while it holds.
std::string RandomProgram::operand_test() {
  static const std::vector<std::string> kInts = {"own[j]",  "own[j]",  "own[j]", "tally[j]",
                                                 "g[1][j]", "g[j][1]", "xs[j]"};
  static const std::vector<std::string> kReals = {"zs[j]", "ws[j]", "levels[j]", "rows[1][j]"};
  static const std::vector<std::string> kOthers = {"s", "t", "k", "2", "3", "n"};
  static const std::vector<std::string> kDivisions = {"s % 3", "t % 2",       "s % 8",
                                                      "t % k", "(s + t) % 4", "s % (n - 1)"};
  static const std::vector<std::string> kCharacters = {"word[j]", "word[k]", "word[j + 1]"};
  const std::string relation = operand_relation();
  const std::string equal = one_in(2) ? " == " : " != ";
  switch (below(6)) {
    case 0:
    case 1:
      return one_in(4) ? one_of(kOthers) + relation + one_of(kInts)
                       : one_of(kInts) + relation + one_of(kOthers);
    case 2:
      return one_in(2) ? one_of(kReals) + relation + "x" : "y" + relation + one_of(kReals);
    case 3:
      return one_of(kDivisions) + equal + "0";
    case 4:
      return one_of(kCharacters) + equal +
             (one_in(2) ? "\"" + std::string(one_in(2) ? "a" : "é") + "\"" : one_of(kCharacters));
    default:
      return "c" + equal + (one_in(2) ? "\"b\"" : "d");
  }
}

// A loop of one statement, most of which are one instruction.
void RandomProgram::operand_loop() {
  static const std::vector<std::string> kHeads = {"for (i in range(n + 1))",
                                                  "for (int i = k; i < n + 2; i++)",
                                                  "for (int i = 0; i <= n; i++)",
                                                  "for (int i = 0; i < 4; i += step)",
                                                  "for (int i = n - 1; i <= 3; i += step)",
                                                  "for (int i = n - 1; i < n; i += step)",
                                                  "for (int i = k - 2; i <= n; i += step)",
                                                  "for (int i = 1; i <= 2; i++)",
                                                  "for (int i = 0; i < own.length; i++)"};
  static const std::vector<std::string> kBodies = {"x += zs[i]",
                                                   "s += own[i]",
                                                   "x += y * zs[i]",
                                                   "x += zs[i] * ws[i]",
                                                   "x += ws[i] * rows[i][k]",
                                                   "own[i] = i",
                                                   "own[i] = s",
                                                   "own[i] = xs[i]",
                                                   "zs[i] += y * ws[i]",
                                                   "zs[i] -= y * zs[k]",
                                                   "rows[1][i] -= x * rows[k][i]",
                                                   "s += g[i][1]",
                                                   "s += g[1][i]",
                                                   "x += rows[k][i]",
                                                   "g[1][i] = g[0][i]",
                                                   "s -= own[i]",
                                                   "x -= zs[i]",
                                                   "s *= own[i]",
                                                   "g[i][k] = s",
                                                   "rows[i][1] += x",
                                                   "own[k] = own[i]",
                                                   "t = own[i] + 1",
                                                   "x = zs[i] - x",
                                                   "x = x * zs[i]",
                                                   "s = own[i] - s",
                                                   "tally[i] = i",
                                                   "s += tally[i]"};
  line(one_of(kHeads) + " { " + one_of(kBodies) + " }");
}

void RandomProgram::operand_statement() {
  static const std::vector<std::string> kSums = {
      "s = s * t + 3",       "t = s * t + j",     "s = s + t + 4",    "s = t - own[k]",
      "s = own[k] - t",      "t = tally[k] + s",  "s = tally[n] * 2", "tally[k] = s",
      "tally[n] += 2",       "x = levels[k] - x", "levels[k] *= y",   "s = codeOf(word[k])",
      "t = codeOf(word[n])", "s = g[n][k] + s",   "t = s + g[k][n]",  "x = y + zs[k]",
      "s = s % 1000",        "j = (j + 1) % 4"};
  switch (below(10)) {
    case 0:
    case 1:
    case 2:
      return line("{\nlet c = word[" + std::string(one_in(2) ? "0" : "k") +
                  "]\nlet d = word[1]\nif (" + operand_test() +
                  (one_in(3) ? " || " + operand_test() : "") + ") { s += 1\nt -= 1 }" +
                  (one_in(2) ? " else { t = t / 2 }" : "") + "\nprint(c, d)\n}");
    case 3:
    case 4: {
      const std::string guard = one_in(2) ? "" : "j < 3 && ";
      const std::string test = one_in(2) ? operand_test() : "!(" + operand_test() + ")";
      return line("{\nlet c = word[0]\nvar d = word[1]\nwhile (" + guard + test +
                  ") { j++\nif (j > 5) { break }\ns += 1\nd = c }\n}");
    }
    case 5:
    case 6:
    case 7:
      return operand_loop();
    case 8: {
      line("switch (" + std::string(one_in(2) ? "s" : "t - 2") + ") {");
      const std::size_t first = below(4);
      for (std::size_t i = 0; i < 5; ++i) {
        line("case " + std::to_string(first + 2 * i - i % 2) + ": { s += " + std::to_string(i) +
             " }");
      }
      return line("default: { t = 1 }\n}");
    }
    default:
      return line(one_of(kSums));
  }
}

}  // namespace armlet::oracle
