// Programs that print the same with and without optimisation, and what they have to print.

#include <doctest/doctest.h>

#include <string>

#include "script_support.hpp"

using armlet::Compilation;
using armlet::RunLimits;
using armlet::lang::compile_script;
using armlet::lang::run_script;
using armlet::lang::trace_script;

namespace {

void prints(const std::string& program, const std::string& expected) {
  INFO(program);
  CHECK(run_script(program, false) == expected);
  CHECK(run_script(program, true) == expected);
}

}  // namespace

TEST_CASE("whole numbers follow Java, apart from overflow") {
  prints("print(7 / 2, -7 / 2, 7 % 3, -7 % 3, 2 ^ 10, -2 ^ 2)", "3 -3 1 -1 1024 -4\n");
  prints("var x = 9223372036854775807\nx = x + 1",
         "R0610 the result of `x + 1` does not fit in an int\n");
  prints("var i = 9223372036854775806\nwhile (i < 9223372036854775807 || i > 0) { i++ }\nprint(i)",
         "R0610 the result of `i++` does not fit in an int\n");
  prints("var z = 0\ntry { print(1 / z) } catch (e) { print(e.kind) }", "DivideByZero\n");
  prints("print(int(2.9), int(-2.9), 3 / 2.0)", "2 -2 1.5\n");
}

TEST_CASE("sums of products keep their two roundings") {
  prints("var s = 0.1\nlet a = 0.7\ns += a * a\nprint(s, 0.1 + a * a, a * a + 0.1, s - a * a)",
         "0.59 0.59 0.59 0.1\n");
  prints("var x = 3.0\nx = x * x + x\nprint(x)\nx = x - x * 2.0 + x\nprint(x)", "12.0\n0.0\n");
  prints("var z = 1.0\nfor (i in range(3)) { z = 2.0 * z * z + z }\nprint(z)", "903.0\n");
  prints(
      "let xs = [1.0, 2.0, 3.0]\nvar s = 0.0\nfor (i in range(3)) { s += xs[i] * xs[i] * xs[2 - i] "
      "}\nprint(s)",
      "20.0\n");
}

TEST_CASE("loops of every form make their passes") {
  prints("for (int i = 0; i < 3; i++) { print(i) }", "0\n1\n2\n");
  prints("for (int i = 3; i > 0; i--) { print(i) }", "3\n2\n1\n");
  prints("for (int i = 0; i <= 4; i += 2) { print(i) }", "0\n2\n4\n");
  prints("for (int i = 0; i < 5; i++) { i++\n print(i) }", "1\n3\n5\n");
  prints("for (i in range(2, 8, 3)) { print(i) }", "2\n5\n");
  prints("var d = -2\nfor (i in range(5, 0, d)) { print(i) }", "5\n3\n1\n");
  prints("for (i in range(0, -1)) { print(i) }\nprint(\"done\")", "done\n");
  prints("var n = 2\nfor (i in range(n)) { n = 10\n print(i) }", "0\n1\n");
  prints("var i = 0\ndo { i++ } while (i < 3)\nprint(i)", "3\n");
  prints(
      "var i = 0\nwhile (true) { i++\n if (i == 2) { continue }\n if (i > 3) { break }\n print(i) "
      "}",
      "1\n3\n");
  prints("var xs = [1, 2, 3]\nfor (x in xs) { xs.push(x)\n print(x) }\nprint(xs)",
         "1\n2\n3\n[1, 2, 3, 1, 2, 3]\n");
  prints(
      "var xs = [1, 2, 3]\nfor (int i = 0; i < xs.length; i++) { if (i < 2) { xs.push(i) } "
      "}\nprint(xs)",
      "[1, 2, 3, 0, 1]\n");
}

TEST_CASE("lists are values") {
  prints("var a = [1, 2, 3]\nvar b = a\nb[0] = 9\nprint(a, b)", "[1, 2, 3] [9, 2, 3]\n");
  prints("var a = [[1, 2], [3]]\nvar b = a\nb[0][1] = 9\nb[1].push(4)\nprint(a, b)",
         "[[1, 2], [3]] [[1, 9], [3, 4]]\n");
  prints(
      "var a = [1, 2, 3]\nfn f(xs: int[]) -> int[] { var ys = xs\n ys[0] = 7\n return ys "
      "}\nprint(f(a), a)",
      "[7, 2, 3] [1, 2, 3]\n");
  prints("var a = new double[2][3]\na[1][2] = 5.0\na[1][2] *= 2.0\nprint(a)",
         "[[0.0, 0.0, 0.0], [0.0, 0.0, 10.0]]\n");
  prints(
      "var a = [1, 2, 3, 4]\nprint(a[1:3], a[:1], a[3:], a.pop(), a.removeAt(0), a)\na.insert(1, "
      "8)\nprint(a, a.length)",
      "[2, 3] [1] [4] 4 1 [2, 3]\n[2, 8, 3] 3\n");
  prints("let a = [1, 2]\nprint(a == [1, 2], a != [1, 2], a == [1])", "true false false\n");
}

TEST_CASE("what stands on the left is evaluated first") {
  prints(
      "var xs = [1, 2, 3]\nfn f(ys: int[], n: int) -> int { return ys.length * 10 + n "
      "}\nprint(f(xs, xs.pop()))",
      "33\n");
  prints(
      "var g = [1, 2, 3]\nfn change() -> int { g[0] = 100\n return 0 }\nprint(g[change()], g[0])",
      "1 100\n");
  prints("var g = [1, 2, 3]\nfn reset() -> int { g = [7]\n return 1 }\nprint(g[reset()], g)",
         "2 [7]\n");
  prints("var n = 1\nfn up() -> int { n += 1\n return n }\nprint(n + up() * n)", "5\n");
  prints("var xs = [5, 6]\nxs[xs.pop() - 6] = xs.length\nprint(xs)", "[1]\n");
  prints("var n = 10\nfn up() -> int { n = 20\n return 1 }\nn += up()\nprint(n)", "21\n");
}

TEST_CASE("variables of the program are safe in quiet loops") {
  prints(
      "var a = [1.0, 2.0]\nfn scale(k: double) { for (int i = 0; i < a.length; i++) { a[i] = a[i] "
      "* k } }\n"
      "var b = a\nscale(2.0)\nprint(a, b)",
      "[2.0, 4.0] [1.0, 2.0]\n");
  prints("var n = 0\nfn count(k: int) { for (i in range(k)) { n += 1 } }\ncount(5)\nprint(n)",
         "5\n");
  prints(
      "var a = [1, 2]\nvar kept: int[][] = []\nfn f() { for (i in range(2)) { a[0] = i + 5\n "
      "kept.push(a) } }\nf()\nprint(kept, a)",
      "[[5, 2], [6, 2]] [6, 2]\n");
  prints(
      "struct P { x: double; y: double }\nvar ps = [P(x: 1.0, y: 2.0), P(x: 3.0, y: 4.0)]\n"
      "fn move() { for (int i = 0; i < ps.length; i++) { ps[i].x += ps[i].y * 10.0 } }\n"
      "let old = ps\nmove()\nprint(ps[0].x, ps[1].x, old[0].x)",
      "21.0 43.0 1.0\n");
}

TEST_CASE("records are values, also inside records and lists") {
  prints(
      "struct P { x: int; y: int }\nvar p = P(x: 1, y: 2)\nvar q = p\nq.x = 5\nq.y += 3\nprint(p, "
      "q)",
      "P(x: 1, y: 2) P(x: 5, y: 5)\n");
  prints(
      "struct N { v: int; kids: N[] }\nvar n = N(v: 1, kids: [N(v: 2, kids: [])])\nn.kids[0] = "
      "n\nn.kids.push(n.kids[0])\n"
      "n.v = 9\nprint(n.kids[0].v, n.kids[1].v, n.kids[0].kids[0].v, n.kids.length)",
      "1 1 2 2\n");
  prints(
      "struct L { name: string; xs: double[] }\nvar l = L(name: \"a\", xs: [1.0])\nl.xs[0] += "
      "1.5\nl.name = l.name + \"b\"\nprint(l)",
      "L(name: \"ab\", xs: [2.5])\n");
}

TEST_CASE("a product is added to a field in place, unless the record is shared") {
  const std::string setup =
      "struct P { x: double }\nvar ps = [P(x: 1.0), P(x: 2.0)]\nlet old = ps\nlet first = "
      "ps[0]\nlet k = sqrt(9.0)\n";
  prints(setup +
             "for (i in range(2)) { ps[i].x += k * k }\nprint(ps[0].x, ps[1].x, old[1].x, first.x)",
         "10.0 11.0 2.0 1.0\n");
  prints(
      setup + "var i = 2\ntry { ps[i].x += k * k } catch (e) { print(e.kind) }\nprint(ps == old)",
      "IndexError\ntrue\n");
  prints(
      "let rows = [[1, 2], [3]]\nvar i = 1\nvar j = 0\nprint(rows[i][j], rows[0][i])\n"
      "try { print(rows[i][i]) } catch (e) { print(e.message) }\ntry { print(rows[i + 1][j]) } "
      "catch (e) { print(e.message) }",
      "3 2\nlist index 1 is outside 0 to 0\nlist index 2 is outside 0 to 1\n");
}

TEST_CASE("texts are joined, grown, cut and compared") {
  prints("var s = \"\"\nfor (i in range(5)) { s = s + i + \",\" }\nprint(s, s.length)",
         "0,1,2,3,4, 10\n");
  prints("var s = \"a\"\nlet t = s\ns += \"b\"\ns = s + s\nprint(s, t)", "abab a\n");
  prints("let s = \"héllo\"\nprint(s[1], s[1:3], s.length)", "é él 5\n");
  prints("print(\"a\" < \"b\", \"b\" <= \"a\", \"a\" == \"a\", \"a\" != \"a\")",
         "true false true false\n");
  prints("let x = 1.5\nprint(f\"{x:.2f} and {2 + 3}\")", "1.50 and 5\n");
}

TEST_CASE("conditions evaluate only what they need") {
  prints(
      "fn yes() -> bool { print(\"y\")\n return true }\nif (false && yes()) { print(1) }\nif (true "
      "|| yes()) { print(2) }\n"
      "let b = yes() && !yes()\nprint(b, b ? 1 : 2)",
      "2\ny\ny\nfalse 2\n");
  prints(
      "var nan = 0.0\nnan = nan / nan\nprint(nan < 1.0, !(nan < 1.0), nan == nan, nan != nan)\nif "
      "(!(nan >= 1.0)) { print(\"no\") }",
      "false true false true\nno\n");
}

TEST_CASE("switch takes one case") {
  prints(
      "fn f(n: int) -> string { switch (n) { case 1: return \"one\"; case 2, 3: return \"few\"; "
      "default: return \"many\" } }\n"
      "print(f(1), f(3), f(9))",
      "one few many\n");
  prints(
      "enum S { A, B }\nfn f(s: S) -> int { switch (s) { case S.A: return 1; case S.B: return 2 } "
      "}\nprint(f(S.A), f(S.B), S.B)",
      "1 2 S.B\n");
  prints("switch (\"x\") { case \"y\": print(1); case \"x\": print(2); break }\nprint(3)",
         "2\n3\n");
}

TEST_CASE("finally runs on every exit") {
  prints(
      "fn f(n: int) -> int { for (i in range(3)) { try { if (n == 0) { continue }\n if (n == 1) { "
      "break }\n if (n == 2) { return i } }"
      " finally { print(\"f\", i) } }\n return -1 }\nprint(f(0))\nprint(f(1))\nprint(f(2))",
      "f 0\nf 1\nf 2\n-1\nf 0\n-1\nf 0\n0\n");
  prints(
      "try { try { throw error(\"a\", kind: \"K\") } finally { print(1) } } catch (e) { "
      "print(e.message, e.kind) }",
      "1\na K\n");
  prints(
      "try { try { throw error(\"a\") } catch (e) { throw error(\"b\") } finally { print(1) } } "
      "catch (e) { print(e.message) }",
      "1\nb\n");
  prints(
      "fn f() -> int[] { var xs = [1]\n try { return xs } finally { xs.push(2)\n print(xs) } "
      "}\nprint(f())",
      "[1, 2]\n[1]\n");
}

TEST_CASE("retry runs the block again") {
  prints(
      "var n = 0\ntry { n += 1\n if (n < 3) { throw error(\"again\") }\n print(n) } catch (e) { "
      "retry } finally { print(\"end\") }",
      "3\nend\n");
}

TEST_CASE("a failed assignment leaves the variable as it was") {
  prints(
      "var x = 1.5\nlet xs = [1.0]\nvar k = 3\ntry { x = 2.0 + xs[k] * 2.0 } catch (e) { "
      "print(e.kind) }\nprint(x)",
      "IndexError\n1.5\n");
  prints(
      "var s = \"a\"\nlet xs = [\"b\"]\nvar k = 3\ntry { s = s + \"c\" + xs[k] } catch (e) { "
      "print(s) }",
      "a\n");
}

TEST_CASE("lambdas copy what they use") {
  prints("var k = 2\nlet f = fn(x: int) => x * k\nk = 100\nprint(f(4), k)", "8 100\n");
  prints("let xs = [1, 2, 3]\nlet f = fn(i: int) => xs[i] + 1\nprint(twice(f, 0))", "4\n");
  prints(
      "fn apply(f: fn(int) -> int, n: int) -> int { return f(f(n)) }\nfn inc(n: int) -> int { "
      "return n + 1 }\nprint(apply(inc, 5), apply(fn(n) => n * n, 3))",
      "7 81\n");
}

TEST_CASE("plain functions of the library are called directly, and still say why they fail") {
  prints("var x = 9.0\nprint(sqrt(x), hypot(3.0, x - 5.0), sqrt(x) * sqrt(x) + 1.0)",
         "3.0 5.0 10.0\n");
  prints("var x = -1.0\nprint(sqrt(x))", "R0609 the root of a negative number\n");
  prints("print(sum([1.0, 2.0]), sum([1, 2]))", "3.0 3.0\n");
}

namespace {

// The same trace from both, and it contains `part`.
void traces(const std::string& program, const std::string& part, const RunLimits& limits = {}) {
  const std::string trace = trace_script(program, true, limits);
  INFO(program);
  CHECK(trace == trace_script(program, false, limits));
  CHECK_MESSAGE(trace.find(part) != std::string::npos, trace);
}

}  // namespace

TEST_CASE("a function that stands in place of its calls is still a call") {
  const std::string half = "fn half(x: int) -> int { return 10 / x }\n";
  traces(half + "print(half(5))", "2\n1 steps\n");
  traces(half + "var n = 3\nfor (i in range(4)) {\n n -= 1\n print(half(n)) }",
         "half, called on line 5");
  traces(half + "for (i in range(100)) { print(half(1)) }", "R0622", {.steps = 20});
  traces(half +
             "fn deep(n: int) -> int {\n if (n == 0) { return half(1) }\n return deep(n - 1)\n}\n"
             "print(deep(8))",
         "10\n", {.call_depth = 10});
  traces(half +
             "fn deep(n: int) -> int {\n if (n == 0) { return half(1) }\n return deep(n - 1)\n}\n"
             "print(deep(9))",
         "R0624 calls are nested more than 10 deep: `half`", {.call_depth = 10});
  traces(half + "try { print(half(0)) } catch (e) { print(e.kind) }", "DivideByZero\n1 steps");
}

TEST_CASE("arguments of a function in place of its call are evaluated once and in order") {
  traces(
      "var n = 1\nfn up() -> int { n += 1\n return n }\nfn twice(a: int, b: int) -> int { return a "
      "+ a + b }\nprint(twice(up(), up()), twice(n, up()))",
      "7 10\n");
  traces(
      "fn pick(xs: double[], i: int) -> double { if (i < 0) { return xs[0] }\n return xs[i] }\n"
      "var a = [1.5, 2.5]\nfn f() -> double { return pick(a, -1) + pick(a, 1) }\nprint(f())\n"
      "print(pick([7.0], 0) + pick(a, 2))",
      "4.0\n5 steps\nR0606");
  traces(
      "fn square(x: double) -> double { return x * x }\nvar x = 3.0\nx = square(x) - square(x + "
      "square(x))\nprint(x, square(square(2.0)))",
      "-135.0 16.0\n");
}

TEST_CASE("what a register holds already is not computed again") {
  const auto calls_in = [](const std::string& text) {
    const Compilation compilation = compile_script(text);
    REQUIRE(compilation.program != nullptr);
    const std::string code = compilation.program->disassemble();
    int calls = 0;
    for (std::size_t at = code.find("CALLD2"); at != std::string::npos;
         at = code.find("CALLD2", at + 1)) {
      ++calls;
    }
    return calls;
  };
  const std::string set = "var x = 3.0\nvar y = 4.0\n";
  const std::string sums = set +
                           "let a = 2.0 * hypot(x, y) + x\nlet b = x - y * hypot(x, y)\n"
                           "print(a, b, hypot(x, y))\n";
  CHECK(calls_in(sums) == 1);
  traces(sums, "13.0 -17.0 5.0\n");
  const std::string changed = set + "let a = hypot(x, y)\nx = 0.0\nprint(a, hypot(x, y))\n";
  CHECK(calls_in(changed) == 2);
  traces(changed, "5.0 4.0\n");
  const std::string element =
      "var xs = [3.0, 4.0]\nlet a = xs[0] * xs[0]\nxs[0] = 5.0\nprint(a, xs[0] * xs[0])";
  traces(element, "9.0 25.0\n");
  traces(
      "let xs = [1.0]\nvar i = 1\nvar t = 0.5\ntry { t = t * 2.0\n let u = xs[i] + t * 2.0\n t = "
      "9.0\n print(u) } catch (e) { print(t) }",
      "1.0\n");
}
