// Rows that are looked up before a loop, values that are known in it, and loops of one instruction:
// nothing of it shows, not even where something fails.

#include <doctest/doctest.h>

#include <string>

#include "code_listing.hpp"

using namespace armlet;
using namespace armlet::lang;

namespace {

// Output, steps, and all of a failure.
void same(const std::string& program, const RunLimits& limits = {}) {
  INFO(program);
  CHECK(trace_script(program, true, limits) == trace_script(program, false, limits));
}

const std::string kEliminate =
    "fn eliminate(m: double[][], i: int, k: int, from: int) -> double[][] {\n"
    "  var a = m\n  let f = m[0][1]\n"
    "  for (int j = from; j < 3; j++) a[i][j] -= f * a[k][j]\n  return a\n}\n";
const std::string kChoose =
    "fn f(d: int[][], i: int, k: int, n: int) -> int[][] {\n  var a = d\n"
    "  for (int j = 0; j < n; j++) {\n"
    "    if (a[i][j] > 100) { a[k][j] = a[i][j + 1] + 1 }\n"
    "    if (j == 2) { a[i][j] = a[k][0] }\n  }\n  return a\n}\n";

}  // namespace

TEST_CASE("subtracting a multiple of a row is one instruction in a loop of its own") {
  const std::string code = listing(kEliminate);
  CHECK(count(code, "OWNROW") == 2);
  CHECK(count(code, "MSUBELX_EACH") == 1);
  CHECK(count(code, "LDLD") == 1);  // m[0][1]
  const std::string rows = "var m = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0]]\n";
  for (const char* call : {"1, 0, 0", "1, 1, 0", "0, 1, 2", "1, 2, 0", "2, 0, 0", "3, 0, 0",
                           "0, -1, 1", "5, 7, 3", "1, 0, -1"}) {
    same(kEliminate + rows + "print(eliminate(m, " + call + "))\nprint(m)");
  }
  // Rows that are the same list stay apart.
  same(kEliminate + rows + "m[1] = m[0]\nlet old = m\nm = eliminate(m, 1, 0, 0)\nprint(m, old)");
}

TEST_CASE("a missing row is reported where it is needed, if it is") {
  const std::string rows = "let d = [[1, 2, 3], [4, 500, 6], [7, 8, 9]]\n";
  for (const char* call : {"0, 9, 2", "0, 9, 3", "1, 9, 1", "1, 9, 2", "9, 0, 1", "9, 0, 0",
                           "1, 0, 2", "1, 1, 3", "-1, 2, 3"}) {
    same(kChoose + rows + "print(f(d, " + call + "))\n");
  }
  // More rows than are looked up before a loop.
  same(
      "fn g(a: int[][], n: int) -> int {\n  var s = 0\n  var b = n\n  var c = n + 1\n"
      "  var d = n + 2\n  var e = n + 3\n  var f = n + 4\n"
      "  for (i in range(2)) { s += a[n][i] + a[b][i] * a[c][i] - a[d][i] + a[e][i] * a[f][i] }\n"
      "  return s\n}\nprint(g([[1, 2], [3, 4], [5, 6], [7, 8], [9, 10]], 0))\n"
      "print(g([[1, 2], [3, 4], [5, 6], [7, 8]], 0))");
}

TEST_CASE("what is computed before a loop and does not change is not computed again in it") {
  const std::string code = listing(
      "fn f(w: int[], t: int[], i: int, n: int) -> int {\n  var a = t\n"
      "  for (int c = n; c >= w[i]; c--) {\n    let x = a[c - w[i]] + 1\n"
      "    if (x > a[c]) { a[c] = x }\n  }\n  return a[0]\n}\nprint(f([1], [1, 2, 3], 0, 2))");
  CHECK(count(code, "LD") == 1);  // w[i], before the loop; the others are operands
  const std::string loops =
      "fn f(n: int, k: int, list: int[]) -> int {\n  var xs = list\n  var s = 0\n  var m = k\n"
      "  for (int i = 0; i < n - k; i++) {\n    if (xs[i] > n - k) { m = m + 1 } else { s = n - k "
      "}\n"
      "    for (int j = m; j < n - m; j++) { xs[j] = xs[i] + n - m }\n"
      "    while (s < xs[m]) { s += 1\n if (s % 5 == 0) { xs[m] = xs[m] - 1 } }\n  }\n"
      "  return s * 1000 + xs[0] * 10 + m\n}\n";
  for (const char* call :
       {"4, 1, [3, 1, 2, 9]", "4, 0, [3, 1, 2, 9]", "5, 2, [3, 1, 2, 9]", "4, 3, [30, 1, 2, 9]"}) {
    same(loops + "print(f(" + call + "))");
  }
}

TEST_CASE("a store into one variable leaves what is known of the others") {
  const std::string code = listing(
      "fn f(xs: int[], i: int) -> int {\n  var a = xs\n  var s = xs[i]\n  a[i] = 7\n"
      "  return s + xs[i] * a[i]\n}\nprint(f([1, 2], 1))");
  CHECK(count(code, "LD") + count(code, "MULIX") + count(code, "ADDIX") == 2);
  same(
      "fn f(xs: int[], i: int) -> int {\n  var a = xs\n  var s = xs[i]\n  a[i] = 7\n"
      "  return s + xs[i] * a[i]\n}\nprint(f([1, 2], 1))");
  same(
      "fn f(g: int[][]) -> int {\n  var a = g\n  let r = a[0]\n  let s = a[0][0]\n  a[0][0] = 9\n"
      "  return s * 100 + a[0][0] * 10 + r[0]\n}\nprint(f([[1], [2]]))");
}

TEST_CASE("loops of one instruction count every pass as a step, and stop where the limit is") {
  const std::string fill =
      "fn f(n: int) -> int {\n  var a = new int[5000]\n  for (int i = 0; i < n; i++) a[i] = i\n"
      "  var s = 0\n  for (int i = 0; i < n; i++) s += a[i]\n  return s\n}\nprint(f(5000))";
  CHECK(count(listing(fill), "ST_EACH") == 1);
  CHECK(count(listing(fill), "ADDIX_EACH") == 1);
  for (const std::uint64_t steps :
       {1U, 2U, 100U, 4095U, 4096U, 4097U, 5000U, 5001U, 9000U, 10002U}) {
    same(fill, {.steps = steps});
  }
}

TEST_CASE("a switch over numbers that lie close together is looked up") {
  const std::string program =
      "fn f(n: int) -> int {\n  switch (n) {\n  case -1: return 1\n  case 0, 1: return 2\n"
      "  case 3: return 3\n  case 5: return 4\n  default: return 0\n  }\n}\n"
      "for (i in range(-4, 8)) { print(f(i)) }\nprint(f(65535), f(9223372036854775807))";
  CHECK(count(listing(program), "SWITCH") == 1);
  same(program);
}
