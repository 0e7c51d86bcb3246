// Values whose last use is to be assigned or passed on change their owner: nothing is copied that
// nobody could see.

#include <doctest/doctest.h>

#include <string>

#include "code_listing.hpp"

using namespace armlet;
using namespace armlet::lang;

namespace {

const std::string kPut =
    "fn put(h: int[], x: int) -> int[] {\n  var r = h\n  r.push(x)\n  return r\n}\n";

bool contains(const std::string& listing, const std::string& op) {
  return listing.find("  " + op + " ") != std::string::npos;
}

void prints(const std::string& program, const std::string& expected) {
  INFO(program);
  CHECK(run_script(program, false) == expected);
  CHECK(run_script(program, true) == expected);
}

// Copying a list of n elements counts n / 256 steps, so a program that copies at every call needs
// more than these.
bool is_quick(const std::string& program) {
  const Compilation compilation = compile_script(program);
  REQUIRE(compilation.program != nullptr);
  VmOptions options;
  options.limits.steps = 100'000;
  Vm vm(compilation.program, std::move(options));
  return !vm.run().error.has_value();
}

}  // namespace

TEST_CASE("h = put(h, x) changes the list itself") {
  CHECK(is_quick(kPut + "var h: int[] = []\nfor (i in range(20000)) { h = put(h, i) }"));
  CHECK(is_quick(kPut + "fn f() { var h: int[] = []\n for (i in range(20000)) { h = put(h, "
                        "h.length) }\n print(h.length) }\nf()"));
  CHECK_FALSE(is_quick(kPut + "var h: int[] = []\nvar old = h\n"
                              "for (i in range(20000)) { old = h\n h = put(h, i) }"));
}

TEST_CASE("what a function passes on is moved too") {
  CHECK(is_quick(kPut + "fn two(h: int[], x: int) -> int[] { return put(put(h, x), x) }\n"
                        "var h: int[] = []\nfor (i in range(10000)) { h = two(h, i) }"));
  CHECK(
      is_quick("struct S { xs: int[]; n: int }\n"
               "fn add(s: S, x: int) -> S { var t = s\n t.xs.push(x)\n t.n += 1\n return t }\n"
               "var s = S(xs: [], n: 0)\nfor (i in range(20000)) { s = add(s, i) }"));
  CHECK(
      is_quick("fn note(t: string) -> string { var u = t\n u += \"ab\"\n return u }\n"
               "var s = \"\"\nfor (i in range(20000)) { s = note(s) }"));
}

TEST_CASE("a value that is needed afterwards stays as it was") {
  prints(kPut + "let h = [1]\nlet k = put(h, 2)\nprint(h, k)", "[1] [1, 2]\n");
  prints(kPut + "var h = [1]\nlet old = h\nh = put(h, 2)\nprint(old, h)", "[1] [1, 2]\n");
  prints(kPut + "var h = [1]\nfor (i in range(2)) { print(put(h, i)) }", "[1, 0]\n[1, 1]\n");
  prints(
      "fn f(a: int[], b: int[]) -> int[] { var c = a\n c[0] = 9\n print(b)\n return c }\n"
      "var h = [1]\nh = f(h, h)\nprint(h)",
      "[1]\n[9]\n");
  prints(
      "fn f(a: int[]) -> int[] { var c = a\n c[0] = 9\n print(a)\n return c }\n"
      "var h = [1]\nh = f(h)\nprint(h)",
      "[1]\n[9]\n");
}

TEST_CASE("a handler sees the value from before the call that failed") {
  const std::string program =
      "fn f(a: int[]) -> int[] { var c = a\n c[0] = 9\n c[5] = 9\n return c }\n"
      "var h = [1]\ntry { h = f(h) } catch { print(h) }\n";
  prints(program, "[1]\n");
  CHECK_FALSE(contains(listing(program), "GIVE"));
}

TEST_CASE("elements that a loop visits outlast the list that is changed") {
  prints(
      "fn f(g: int[][]) { for (r in g) { var k = g\n k[0] = [7]\n print(r, k)\n return } }\n"
      "f([[1], [2]])",
      "[1] [[7], [2]]\n");
  prints(kPut +
             "fn f(a: int[]) { var h = a\n for (x in h) { let k = put(h, 5)\n print(x, k)\n"
             " break } }\nf([1])",
         "1 [1, 5]\n");
}

TEST_CASE("the last use of a variable takes its value") {
  const std::string code = listing(
      "fn f(a: int[]) -> int[] { var b = a\n b[0] = 1\n var c = b\n"
      " c[0] = 2\n return c }\nprint(f([0]))");
  CHECK(contains(code, "ADOPT"));
  CHECK_FALSE(contains(code, "MOVEREF"));
}

TEST_CASE("a call that fails before it begins leaves the value with its owner") {
  prints(
      "fn deep(h: int[], n: int) -> int[] { var r = h\n r.push(n)\n return deep(r, n + 1) }\n"
      "fn f() -> int { var h = [1]\n try { h = deep(h, 0) } catch { return h.length }\n"
      " return 0 }\nprint(f())",
      "1\n");
}
