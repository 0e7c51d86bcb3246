// Calls: overloads, named and default values, x.f(a), lambdas, the robot that is not written.

#include <doctest/doctest.h>

#include "check_vocabulary.hpp"

namespace armlet::lang {
namespace {

TEST_CASE("the overload with the fewest conversions is taken") {
  CHECK(type_of("abs(-3)") == "int");
  CHECK(type_of("abs(-3mm)") == "length");
  CHECK(type_of("min(1, 2)") == "int");
  CHECK(type_of("min(1, 2.5)") == "double");
  CHECK(type_of("min(0, 5mm)") == "length");
  CHECK(type_of("min([1mm, 2mm])") == "length");
  CHECK(type_of("sum([1, 2])") == "int");
  CHECK(type_of("sum([1.5])") == "double");
  CHECK(type_of("min(1mm, 2s)") == "E0402");
  CHECK(type_of("Math.sqrt(4.0) + Math.PI") == "double");
  CHECK(type_of("sqrt(4.0, 2.0)") == "E0312");
  CHECK(type_of("sqrt()") == "E0312");
}

TEST_CASE("settings are named, given once and known") {
  CHECK(type_of("xyz(z: 1mm)") == "posC");
  CHECK(type_of("xyz(1mm, z: 1mm)") == "posC");
  CHECK(type_of("xyz(1mm, x: 1mm)") == "E0212");
  CHECK(type_of("xyz(z: 1mm, 2mm)") == "E0326");
  CHECK(type_of("xyz(q: 1mm)") == "E0207");
}

TEST_CASE("x.f(a) means f(x, a)") {
  CHECK(type_of("[1.5, 2.5].min()") == "double");
  CHECK(type_of("(2).twice()", "fn twice(n: int) => 2 * n") == "int");
  CHECK(type_of("(2).nothing()") == "E0201");
}

TEST_CASE("lambdas take their parameter types from the function they are passed to") {
  CHECK(type_of("map([1, 2], fn(x) => x * 1mm)") == "length[]");
  CHECK(type_of("[1, 2].map(fn(x) => \"a\" + x)") == "string[]");
  CHECK(type_of("solve(fn(x) => x ^ 2 - 2, 0, 2)") == "double");
  CHECK(type_of("solve(square, 0, 2)", "fn square(x) => x * x") == "double");
  CHECK(type_of("fn(x: double) => x > 0") == "fn(double) -> bool");
  CHECK(type_of("fn(x) => x") == "E0323");
}

TEST_CASE("a lambda copies what it uses and cannot change it") {
  const auto reads = check_text("var n = 1\nlet f = fn() => n + 1\nn = 2");
  REQUIRE(reads->ok);
  const hir::Function* lambda = reads->function("lambda on line 2");
  REQUIRE(lambda != nullptr);
  REQUIRE(lambda->captures.size() == 1);
  CHECK(lambda->captures[0].outer->name == "n");
  CHECK(lambda->captures[0].inner->storage == hir::Storage::kLocal);
  CHECK(check_text("var n = 0\nlet count = fn() { n = n + 1 }")->codes() == "E0210");
  CHECK(check_text("let n = 1\nlet f = fn(n: int) => n")->codes() == "E0204");
}

TEST_CASE(
    "a function without parameter types is made once for every combination of argument types") {
  const auto checked = check_text(
      "fn square(x) => x * x\nlet a = square(3)\nlet b = square(2mm)\nlet c = square(4)");
  REQUIRE(checked->ok);
  CHECK(type_name(checked->variable(0).type) == "int");
  CHECK(type_name(checked->variable(1).type) == "area");
  CHECK(checked->program.module.functions.size() == 3);
}

TEST_CASE("a mistake in a generic function names the line inside and the call") {
  const auto checked = check_text("fn twice(x) => x * \"a\"\nlet a = twice(3)\n");
  CHECK(checked->codes() == "E0314");
  REQUIRE(checked->messages[0].related.size() == 1);
  CHECK(checked->messages[0].related[0].label == "called here with an int");
}

TEST_CASE("recursion needs a written result only where nothing else determines it") {
  CHECK(type_of("fact(5)", "fn fact(n: int) -> int => n < 2 ? 1 : n * fact(n - 1)") == "int");
  CHECK(check_text("fn fact(n) => n < 2 ? 1 : n * fact(n - 1)\nprint(fact(3))")->codes() ==
        "E0324");
  CHECK(check_text("fn f(x) -> int { return f([x]) }\nprint(f(1))")->codes() == "E0125");
  CHECK(check_text("fn down(n) { if (n > 0) down(n - 1) }\ndown(3)")->ok);
}

TEST_CASE("functions are seen before their text, with defaults and names") {
  CHECK(type_of("f(1)", "fn f(a: int, b: double = 2) => a + b") == "double");
  CHECK(type_of("f(b: 1, a: 2)", "fn f(a: int, b: double = 2) => a + b") == "double");
  CHECK(check_text("let x = later(2)\nfn later(n: int) => n + 1")->ok);
  CHECK(check_text("fn f(n: double = random()) => n\nprint(f())")->codes() == "E0334");
  CHECK(check_text("fn twice(n: int) => 2 * n\nprint(twice(\"3\"))")->codes() == "E0314");
  CHECK(check_text("fn twice(n: int) => 2 * n\nprint(twice(1, 2))")->codes() == "E0312");
}

TEST_CASE("the only robot of the program is the one that moves") {
  CHECK(check_text("robot arm = robots.two()\nmoveJ(posJ(1deg, 2deg), time: 1s)")->ok);
  CHECK(check_text("moveJ(posJ(1deg, 2deg), time: 1s)")->ok);
  CHECK(
      check_text("let a = robots.two()\nlet b = robots.two()\nmoveJ(posJ(1deg, 2deg))")->codes() ==
      "E0205");
  CHECK(check_text("let a = robots.two()\nlet b = robots.two()\na.moveJ(posJ(1deg, 2deg))")->ok);
  CHECK(check_text("moveJ('Syn', new posJ([1, 2]), 1.0);")->ok);
}

TEST_CASE("rules see facts, constants and where a list was written") {
  CHECK(check_text("robot arm = robots.two()\narm.moveJ(new posJ([1, 2, 3]))")->codes() == "E0302");
  CHECK(check_text("double[] q = {1, 2, 3};\nposJ p = new posJ(q);\nmoveJ(p)")->codes() == "E0302");
  CHECK(check_text("double[] q = {1, 2, 3};\nq[0] = 2;\nposJ p = new posJ(q);\nmoveJ(p)")->ok);
}

TEST_CASE("a block declaration passes its fields and rows to the type") {
  CHECK(check_text("robot arm { joint revolute(a: 1m, limits: [-1deg, 1deg]); base: xyz() "
                   "}\nprint(arm.force())")
            ->ok);
  CHECK(check_text("robot arm { joint revolut(a: 1m) }")->codes() == "E0201");
  CHECK(check_text("robot arm { joint revolute(a: 1m); bas: xyz() }")->codes() == "E0207");
  CHECK(check_text("struct P { a: int; b: length = 1mm }\nP p { a: 3 }\nprint(p.b)")->ok);
  CHECK(check_text("struct P { a: int }\nP p { }")->codes() == "E0312");
}

}  // namespace
}  // namespace armlet::lang
