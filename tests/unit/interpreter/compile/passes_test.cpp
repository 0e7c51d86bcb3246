// What the last passes of the compiler make of typical loops, and what they leave alone.

#include <doctest/doctest.h>

#include <string>

#include "code_listing.hpp"

using namespace armlet;
using namespace armlet::lang;

namespace {

void outputs(const std::string& program, const std::string& expected) {
  INFO(program);
  CHECK(run_script(program, false) == expected);
  CHECK(run_script(program, true) == expected);
}

const std::string kCross =
    "fn cross(a: double, b: double, c: double, d: double, n: double) -> double {\n"
    "  var s = a * b - c * d\n  s = s + (a * b + c * d)\n  return s / n\n}\n";
const std::string kMultiply =
    "fn cell(a: double[][], b: double[][], i: int, j: int, n: int) -> double {\n"
    "  var s = 0.0\n  for (k in range(n)) { s += a[i][k] * b[k][j] }\n  return s\n}\n";
const std::string kStruct =
    "struct P { x: double; y: double; z: double }\nvar ps = [P(x: 1.0, y: 2.0, z: 3.0)]\n";
const std::string kFar = kStruct +
                         "fn far(ps: P[], i: int, k: double) -> double {\n"
                         "  return ps[i].x + ps[i].y * k + ps[i].z\n}\n";
const std::string kMove =
    kStruct +
    "fn move(i: int, k: double, d: double) {\n  for (n in range(1)) { ps[i].x += k * d\n"
    "    ps[i].y += d * d\n    ps[i].z = d }\n}\n";

}  // namespace

TEST_CASE("sums and differences of two products are one instruction") {
  CHECK(count(listing(kCross), "DIFFP") == 1);
  outputs(kCross + "print(cross(3.0, 2.0, 0.5, 4.0, 2.0))", "6.0\n");
  // The accumulator is one of the factors.
  outputs(
      "fn f(a: double) -> double {\n  var s = a * a\n  s = s + s * a\n  return s\n}\nprint(f(3.0))",
      "36.0\n");
}

TEST_CASE("a row that stays the same is looked up before the loop") {
  const std::string code = listing(kMultiply);
  CHECK(count(code, "MADDROW_EACH") == 1);
  CHECK(count(code, "LDLD") == 0);
  const std::string rows = "let m = [[1.0, 2.0], [3.0, 4.0]]\n";
  outputs(kMultiply + rows + "print(cell(m, m, 1, 0, 2), cell([], [], 5, 0, 0))", "15.0 0.0\n");
  // The first failure of the first pass, on its line and in its pass.
  const std::string tried = "try { print(cell(m, m, 7, 9, 2)) } catch (e) { print(e.message) }\n";
  outputs(kMultiply + rows + tried, "list index 7 is outside 0 to 1\n");
  outputs(kMultiply + rows + "try { print(cell(m, m, 1, 9, 2)) } catch (e) { print(e.message) }",
          "list index 9 is outside 0 to 1\n");
}

TEST_CASE("a row is looked up in every pass when something in the loop could change it") {
  for (const char* body :
       {"s += a[i][k] * 2.0\n i = 0", "try { s += a[i][k] * 2.0 } catch { s = 1.0 }",
        "print(s)\n s += a[i][k] * 2.0", "s += a[i][k] * 2.0\n a[i] = [s, s]"}) {
    const std::string loop =
        "fn f(rows: double[][], xs: double[]) -> double {\n  var a = rows\n"
        "  var s = 0.0\n  var i = 1\n  for (k in range(2)) { " +
        std::string(body) + " }\n  return s\n}\n";
    INFO(loop);
    const std::string code = listing(loop);
    CHECK(count(code, "LDLD") + count(code, "MADDLDLD") + count(code, "MADDLDLD_A") +
              count(code, "MADDROW") + count(code, "MADDROW_A") >=
          1);
    const std::string call = "print(f([[1.0, 2.0], [3.0, 4.0]], [1.0]))";
    CHECK(run_script(loop + call, true) == run_script(loop + call, false));
  }
}

TEST_CASE("fields of one element share the access to it") {
  const std::string code = listing(kFar);
  CHECK(count(code, "FLD") == 2);
  CHECK(count(code, "ADDF_W") == 1);
  CHECK(count(code, "LDF") == 0);
  outputs(kFar + "print(far(ps, 0, 2.0))", "8.0\n");
  outputs(kFar + "try { print(far(ps, 1, 2.0)) } catch (e) { print(e.message) }",
          "list index 1 is outside 0 to 0\n");
}

TEST_CASE("changes to one element make it the program's own once") {
  const std::string code = listing(kMove);
  CHECK(count(code, "OWNED") == 1);
  CHECK(count(code, "MADDF") == 2);
  CHECK(count(code, "SETF") == 1);
  outputs(kMove + "let old = ps\nlet first = ps[0]\nmove(0, 2.0, 8.0)\nprint(ps, old, first)",
          "[P(x: 17.0, y: 66.0, z: 8.0)] [P(x: 1.0, y: 2.0, z: 3.0)] P(x: 1.0, y: 2.0, z: 3.0)\n");
  outputs(kMove + "try { move(1, 2.0, 8.0) } catch (e) { print(e.message, ps) }",
          "list index 1 is outside 0 to 0 [P(x: 1.0, y: 2.0, z: 3.0)]\n");
}

TEST_CASE("an element that may have become another is looked up again") {
  outputs(
      "struct P { x: double; y: double; z: double }\nvar ps = [P(x: 1.0, y: 2.0, z: 3.0)]\n"
      "fn renew() -> double { ps = [P(x: 10.0, y: 20.0, z: 30.0)]\n  return 0.5 }\n"
      "fn f(i: int) -> double { return ps[i].x + ps[i].y + renew() + ps[i].x + ps[i].z + ps[i].y "
      "}\n"
      "print(f(0))",
      "63.5\n");
  outputs(
      "struct P { x: double; y: double }\nvar ps = [P(x: 1.0, y: 2.0), P(x: 5.0, y: 6.0)]\n"
      "fn f() {\n  var i = 0\n  for (n in range(2)) { ps[i].x = 7.0\n    ps[i].y = 8.0\n    i = 1\n"
      "    ps[i].x = 9.0 } }\nf()\nprint(ps)",
      "[P(x: 7.0, y: 8.0), P(x: 9.0, y: 8.0)]\n");
  outputs(
      "struct P { x: double; y: double }\nfn f(ps: P[]) -> P[] {\n  var a = ps\n  a[0].x = 3.0\n"
      "  let b = a\n  a[0].y = 4.0\n  return [a[0], b[0], ps[0]]\n}\nprint(f([P(x: 1.0, y: 2.0)]))",
      "[P(x: 3.0, y: 4.0), P(x: 3.0, y: 2.0), P(x: 1.0, y: 2.0)]\n");
}
