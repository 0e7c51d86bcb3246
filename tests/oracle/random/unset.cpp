// Lists whose elements are not set yet, copied and looked into in every form: whatever reads such
// an element fails, whatever only passes it on does not.

#include "random/program.hpp"

namespace armlet::oracle {

namespace {

// @: a list; #: an index.
const std::vector<std::string> kReads = {"x = @[#].n",
                                         "x += @[#].marks.length",
                                         "for (v in @) { x += v.n }",
                                         "for (v in @) { if (v.n > 1) { break } }",
                                         "s = string(@)",
                                         "print(@, x)",
                                         "print(\"all\", t, u)",
                                         "x = @[0:#].length",
                                         "x += map(@, fn(v: Part) => v.n).length",
                                         "x += filter(@, fn(v: Part) => v.n > 0).length",
                                         "x = fold(@, 0, fn(sum: int, v: Part) => sum + v.n)",
                                         "x = any(@, fn(v: Part) => v.n == 1) ? 1 : 2",
                                         "x = sort(@, by: fn(v: Part) => v.n)[0].n",
                                         "x = @ == a ? 3 : 4",
                                         "x = t != u[0] ? 5 : 6",
                                         "x = indexOf(@, Part(1, []))",
                                         "x = contains(a, Part(2, [2])) ? 7 : 8",
                                         "x = reverse(@)[0].n",
                                         "x = @.last.n",
                                         "x = same(@).length",
                                         "x = first(@)",
                                         "x = zip(a, @).length",
                                         "{ let w = @[#] }",
                                         "x = m == [\"k\": b] ? 1 : 0",
                                         "s = f\"{x} {g} {a}\"",
                                         "x = (p.piles[0]).piles.length",
                                         "s = string(p)"};

const std::vector<std::string> kWrites = {"@[#] = Part(n, [n])",
                                          "@[#] = Part(1, [])",
                                          "@[0] = Part(0, [1, 2])",
                                          "@[#].n = 4",
                                          "@[#].n += 2",
                                          "@[#].marks.push(x)",
                                          "@[#].marks[0] += 1",
                                          "@.push(Part(5, []))",
                                          "@.insert(0, Part(6, [6]))",
                                          "x = @.pop().n",
                                          "x = @.removeAt(#).n",
                                          "@[0:1] = [Part(7, [7])]",
                                          "@[1:2] = b[1:2]",
                                          "@[0:b.length] = b",
                                          "@ = b",
                                          "b = @",
                                          "a = same(@)",
                                          "g[0] = @",
                                          "t.parts = @",
                                          "u[n % 2] = t",
                                          "t = Tray(parts: @)",
                                          "m[\"j\"] = @",
                                          "p = Pile(\"q\", [p, p])",
                                          "p.piles[0] = Pile(\"r\", [])",
                                          "for (k in range(@.length)) { @[k] = Part(k, [k]) }"};

}  // namespace

void RandomProgram::declare_unset() {
  line("struct Part { n: int; marks: int[] }");
  line("struct Tray { parts: Part[]; label: string = \"t\" }");
  line("struct Pile { label: string; piles: Pile[] }");
  line("var stock = new Part[3]");
  open("fn same(p: Part[]) -> Part[]");
  line(one_in(2) ? "return p" : "var q = p\nq.push(Part(9, []))\nreturn q");
  close();
  open("fn first(p: Part[]) -> int");
  line("return p[0].n");
  close();
  open("fn unsetting(n: int)");
  line("var a = new Part[3]\nvar b = a\nvar g = new Part[2][2]\nvar t = Tray(new Part[2])");
  line("var u = new Tray[2]\nvar m = [\"k\": new Part[1]]\nvar x = 0");
  line("var p = Pile(\"p\", new Pile[1])\nvar s = \"\"");
  const std::size_t count = 8 + below(12);
  for (std::size_t i = 0; i < count; ++i) {
    if (one_in(3)) {
      unset_statement();
      continue;
    }
    open("try");
    unset_statement();
    close(" catch (e) { print(e.kind, e.message, e.line) }");
  }
  line("print(x, s, a.length, b.length, g.length)");
  close();
  line("for (n in range(3)) {\ntry { unsetting(n) }");
  line("catch (e) { print(e.message, e.line) }\n}");
}

void RandomProgram::unset_statement() {
  static const std::vector<std::string> kLists = {"a",        "b",       "a",      "g[0]",
                                                  "g[n % 2]", "t.parts", "b",      "u[0].parts",
                                                  "m[\"k\"]", "stock",   "same(a)"};
  static const std::vector<std::string> kPlaces = {"a",          "b",        "g[1]", "t.parts",
                                                   "u[1].parts", "m[\"k\"]", "stock"};
  static const std::vector<std::string> kIndices = {"0",    "1", "n", "n % 2", "a.length - 1",
                                                    "x % 3"};
  const std::string xs = one_of(kLists);
  const std::string to = one_of(kPlaces);
  const std::string i = one_of(kIndices);
  const bool reads = one_in(2);
  std::string text;
  for (const char c : one_of(reads ? kReads : kWrites))
    text += c == '@' ? (reads ? xs : to) : c == '#' ? i : std::string(1, c);
  line(text);
}

}  // namespace armlet::oracle
