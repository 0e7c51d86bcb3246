// Statements: what can be changed, what has a value, what is reached, what is not there yet.

#include <doctest/doctest.h>

#include "check_vocabulary.hpp"

namespace armlet::lang {
namespace {

TEST_CASE("names are declared once in a function") {
  CHECK(check_text("let p = 1\nlet p = 2")->codes() == "E0204");
  CHECK(check_text("for (i in range(3)) { print(i) }\nfor (i in range(3)) { print(i) }")->ok);
  CHECK(check_text("let p = 1\nif (p > 0) { let p = 2\nprint(p) }")->codes() == "E0204");
  CHECK(check_text("let p = 1\nfn f() { let p = 2\nprint(p) }\nprint(p)")->codes() == "W0708");
}

TEST_CASE("fixed names, parameters and loop variables cannot be changed") {
  CHECK(check_text("let n = 1\nn = 2")->codes() == "E0206");
  CHECK(check_text("final int n = 1;\nn++;")->codes() == "E0206");
  CHECK(check_text("for (i in range(3)) { i = 2 }")->codes() == "E0206");
  CHECK(check_text("void fill(double[] a) { a[0] = 1.0; }")->codes() == "E0308");
  CHECK(check_text("let xs = [1]\nxs.push(2)")->codes() == "E0206");
  CHECK(
      check_text(
          "var xs = [1]\nxs.push(2)\nxs.insert(0, 3)\nlet n = xs.pop() + xs.removeAt(0)\nprint(n)")
          ->ok);
}

TEST_CASE("elements, fields and nested targets can be assigned") {
  CHECK(check_text("struct P { a: int[] }\nvar p = P(a: [1])\np.a[0] = 2\np.a[0] += 3\np.a[0]++")
            ->ok);
  CHECK(check_text("int a, b;\na = b = 0;\nprint(a, b)")->ok);
  CHECK(check_text("var s = \"a\"\ns += 3\nvar xs = [1.0]\nxs += [2.0]")->ok);
  CHECK(check_text("var x = 1mm\nx *= 2\nx += 1mm")->ok);
  CHECK(check_text("var x = 1mm\nx += 1")->codes() == "E0401");
  CHECK(check_text("var n = 1\nn += 0.5")->codes() == "E0303");
  CHECK(check_text("joints() = 3")->codes() == "E0328");
  CHECK(check_text("let s = \"abc\"\ns[0] = \"x\"")->codes() == "E0328");
  CHECK(check_text("struct P { a: int }\nvar p = P(a: 1)\np.b = 2")->codes() == "E0208");
}

TEST_CASE("a variable has a value on every path to its use") {
  CHECK(check_text("double x;\nprint(x)")->codes() == "E0211");
  CHECK(check_text("double x;\nif (random() < 0.5) { x = 1 }\nprint(x)")->codes() == "E0211");
  CHECK(check_text("double x;\nif (random() < 0.5) { x = 1 } else { x = 2 }\nprint(x)")->ok);
  CHECK(check_text("double x;\nwhile (true) { x = 1\nbreak }\nprint(x)")->ok);
  CHECK(check_text("double x;\ndo { x = 1 } while (x < 0)\nprint(x)")->ok);
  CHECK(check_text("double x;\ntry { x = 1 } catch (e) { throw e }\nprint(x)")->ok);
  CHECK(check_text("double x;\ntry { x = 1 } catch (e) { print(e.message) }\nprint(x)")->codes() ==
        "E0211");
  CHECK(check_text("double x;\nswitch (3) { case 1: x = 1; default: x = 2 }\nprint(x)")->ok);
}

TEST_CASE("a function that promises a result returns one on every path") {
  CHECK(check_text("fn f(i: int) -> int { if (i > 0) return i }")->codes() == "E0306");
  CHECK(check_text("fn f(i: int) -> int { if (i > 0) return i else throw error(\"no\") }")->ok);
  CHECK(check_text("fn f(i: int) -> int { while (true) { print(i) } }")->ok);
  CHECK(check_text("void f() { return 3; }")->codes() == "E0321");
  CHECK(check_text("int f() { return; }")->codes() == "E0322");
  CHECK(check_text("int f() { return 1.5; }")->codes() == "E0303");
  CHECK(check_text("fn f(i: int) { if (i > 0) return 1\nreturn 2.5 }\nlet x = f(1)\nprint(x)")->ok);
}

TEST_CASE("break, continue, return and retry stand where they make sense") {
  CHECK(check_text("break")->codes() == "E0121");
  CHECK(check_text("switch (1) { default: continue }")->codes() == "E0121");
  CHECK(check_text("return")->codes() == "E0121");
  CHECK(check_text("try { print(1) } catch (e) { retry }")->ok);
  CHECK(check_text("try { retry } catch (e) { print(1) }")->codes() == "E0121");
}

TEST_CASE("a switch handles every value of an enum, each once") {
  const std::string head = "enum L { Red, Green }\nlet l = L.Red\n";
  CHECK(check_text(head + "switch (l) { case L.Red: print(1) }")->codes() == "E0307");
  CHECK(check_text(head + "switch (l) { case L.Red: case L.Green: print(1) }")->ok);
  CHECK(check_text(head +
                   "switch (l) { case L.Red: print(1); case L.Red: print(2); default: print(3) }")
            ->codes() == "E0329");
  CHECK(check_text("switch (1.5) { default: print(1) }")->codes() == "E0315");
  CHECK(check_text("switch (2) { case 1: print(1); break; case 2: print(2); case 3: print(3) }")
            ->codes() == "W0713");
}

TEST_CASE("what runs on top-level variables shares them as globals") {
  const auto checked = check_text("var n = 1\nlet m = 2\nfn f() { n += 1 }\nf()\nprint(m)");
  REQUIRE(checked->ok);
  CHECK(checked->variable(0).storage == hir::Storage::kGlobal);
  CHECK_FALSE(checked->variable(0).maybe_unset);
  CHECK(checked->variable(1).storage == hir::Storage::kLocal);
  CHECK(checked->program.module.global_count == 1);
}

TEST_CASE("a call above a declaration makes its reads checked ones") {
  const auto checked =
      check_text("fn f() -> int => n\nif (random() > 2) { print(f()) }\nvar n = 1\nprint(f())");
  REQUIRE(checked->ok);
  CHECK(checked->variable(1).maybe_unset);
  CHECK(check_text("fn f() => n\nprint(f())\nlet n = 1")->codes() == "E0211");
}

TEST_CASE("conditions share variables and cannot wait") {
  const auto checked = check_text(
      "fn f() { var taken = false\nlet limit = 3N\nwait until taken || force() > limit\ntaken = "
      "true }");
  REQUIRE(checked->ok);
  const hir::Function* condition = checked->function("condition on line 3");
  REQUIRE(condition != nullptr);
  REQUIRE(condition->captures.size() == 2);
  CHECK(condition->captures[0].inner->storage == hir::Storage::kBoxed);
  CHECK(condition->captures[1].inner->storage == hir::Storage::kLocal);
  CHECK(
      check_text("fn go() -> bool { moveJ(posJ(1, 2))\nreturn true }\nwait until go()")->codes() ==
      "E0505");
  CHECK(check_text("moveL(xyz(), speed: 1mm/s) until force() > 8N")->ok);
  CHECK(check_text("print(1) until force() > 8N")->codes() != "");
}

TEST_CASE("tests are functions that begin with the first values they need") {
  const auto checked = check_text(
      "let a = 1\nlet b = a + 1\nlet c = 5\nfn f() => b\ntest \"sum\" { assert(f() == 2) }");
  REQUIRE(checked->ok);
  REQUIRE(checked->program.module.tests.size() == 1);
  const auto& body = checked->program.module.tests[0].function->body->body;
  REQUIRE(body.size() == 3);
  CHECK(body[0]->as<hir::InitStmt>().variable->name == "a");
  CHECK(body[1]->as<hir::InitStmt>().variable->name == "b");
  const auto& assertion = body[2]->as<hir::AssertStmt>();
  CHECK(assertion.text == "f() == 2");
  REQUIRE(assertion.shown.size() == 1);
  CHECK(assertion.shown[0].text == "f()");
}

TEST_CASE("advice is given for what is surely a slip") {
  CHECK(check_text("double half = 1 / 2;")->codes() == "W0701");
  CHECK(check_text("int mask = 2 ^ 3;")->codes() == "W0703");
  CHECK(check_text("let n = 2 ^ 3")->codes() == "");
  CHECK(check_text("fn f() { let n = 3\nprint(4) }")->codes() == "W0709");
  CHECK(check_text("fn f() { return\n3 }")->codes() == "W0705");
  CHECK(check_text("fn f() { return 3\nprint(1) }")->codes() == "W0710");
  CHECK(check_text("var x = 1\nx + 1")->codes() == "E0332");
}

TEST_CASE("one mistake gives one message, and others are still found") {
  CHECK(check_text("let a = nowhere + 1\nlet b = a * 2\nprint(b.x)\nlet c = also")->codes() ==
        "E0201 E0201");
  CHECK(check_text("let a = 3 4\nprint(a)")->messages.size() == 1);
}

TEST_CASE("structs have defaults and do not contain themselves") {
  CHECK(check_text("struct Part { inner: Part }")->codes() == "E0333");
  CHECK(check_text("struct Part { inner: Part[] }")->ok);
  CHECK(check_text("struct P { a: int; a: int }")->codes() == "E0204");
  CHECK(check_text("let n: number = 3")->codes() == "E0216");
}

TEST_CASE("classic lines are ordinary ones") {
  CHECK(
      check_text(
          "System.out.println(\"d = \" + Math.pow(2, 3));\nThread.sleep(500);\nwait(0.5)\nwait(2s)")
          ->ok);
  CHECK(check_text("String[] names = {\"a\", \"b\"};\nfor (int i = 0; i < names.length; i++) "
                   "System.out.println(names[i]);")
            ->ok);
  CHECK(check_text("try { throw error(\"no\", kind: \"x\") } catch (e) { print(e.getMessage(), "
                   "e.kind, e.line) }")
            ->ok);
  CHECK(check_text("throw \"no\"")->codes() == "E0315");
}

}  // namespace
}  // namespace armlet::lang
