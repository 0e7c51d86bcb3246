// Functions of lists as loops: the same result, and the same steps, however they are compiled.

#include <doctest/doctest.h>

#include <string>

#include "script_support.hpp"

namespace armlet::lang {
namespace {

constexpr NativeFunction kLoops[] = {
    {.name = "map", .signature = "(xs: T[], f: fn(T) -> U) -> U[]"},
    {.name = "filter", .signature = "(xs: T[], f: fn(T) -> bool) -> T[]"},
    {.name = "fold", .signature = "(xs: T[], start: U, f: fn(U, T) -> U) -> U"},
    {.name = "any", .signature = "(xs: T[], f: fn(T) -> bool) -> bool"},
    {.name = "all", .signature = "(xs: T[], f: fn(T) -> bool) -> bool"},
    {.name = "sort", .signature = "(xs: T[], by: fn(T) -> U, descending: bool = false) -> T[]"},
    {.name = "zip", .signature = "(xs: T[], ys: U[]) -> Pair{first: T, second: U}[]"},
    {.name = "contains", .signature = "(xs: T[], x: T) -> bool"},
    {.name = "indexOf", .signature = "(xs: T[], x: T) -> int"},
};

const Engine& engine() {
  static const Engine made = [] {
    Engine e;
    e.add_functions(script_library::kFunctions);
    e.add_functions(kLoops);
    return e;
  }();
  return made;
}

ScriptRun run(const std::string& text, bool optimise, const RunLimits& limits = {}) {
  const Compilation compilation =
      compile_text(engine().registry(), text, "test.rbt", {.open = false}, {.optimise = optimise});
  for (const Diagnostic& d : compilation.diagnostics) {
    if (d.severity == Severity::kError) FAIL(d.code << ": " << d.message << " in\n" << text);
  }
  return run_compiled(compilation.program, limits);
}

struct Case {
  std::string text;
  std::string printed;
};

// One for every loop, over numbers and over references, with known functions and with closures.
const Case kCases[] = {
    {"print([1, 2, 3].map(fn(x) => x * x))", "[1, 4, 9]\n"},
    {"let k = 2.0\nprint([1.5, 2.5].map(fn(x) => x * k))", "[3.0, 5.0]\n"},
    {"print([1, 2].map(fn(x) => \"n\" + x))", "[\"n1\", \"n2\"]\n"},
    {"print([[1], [2, 3]].map(fn(r) => r.length))", "[1, 2]\n"},
    {"var xs = [[1], [2]]\nxs = xs.map(fn(r) => r)\nxs[0].push(5)\nprint(xs)", "[[1, 5], [2]]\n"},
    {"let low = 1\nprint([1, 2, 3].filter(fn(x) => x > low))", "[2, 3]\n"},
    {"print([\"a\", \"bb\"].filter(fn(s) => s.length > 1))", "[\"bb\"]\n"},
    {"print([1, 2, 3, 4].fold(0, fn(a, x) => a - x))", "-10\n"},
    {"print([\"a\", \"b\"].fold(\"\", fn(t, s) => s + t))", "ba\n"},
    {"print([1, 2, 3].any(fn(x) => x == 2), [1].any(fn(x) => x > 1))", "true false\n"},
    {"print([1, 2, 3].all(fn(x) => x < 3), [1].all(fn(x) => x > 0))", "false true\n"},
    {"print([3, 1, 2].sort(by: fn(x) => -x), [\"b\", \"a\"].sort(by: fn(s) => s))",
     "[3, 2, 1] [\"a\", \"b\"]\n"},
    {"print([[2, 1], [1], [1, 5]].sort(by: fn(r) => r[0]))", "[[1], [1, 5], [2, 1]]\n"},
    {"print(zip([1, 2], [\"a\", \"b\"]))",
     "[Pair(first: 1, second: \"a\"), Pair(first: 2, second: \"b\")]\n"},
    {"print([1, 2].contains(2), [\"a\"].contains(\"b\"), [[1], [2]].indexOf([2]))",
     "true false 1\n"},
    {"fn f(x: double) -> double { if (x < 1.0) { return 0.0 }\n return x + 1.0 }\n"
     "print([0.5, 1.5].map(f))",
     "[0.0, 2.5]\n"},
    {"var n = 0\nfn f(x: int) -> int { n += x\n return n }\nprint([1, 2, 3].map(f), n)",
     "[1, 3, 6] 6\n"},
    {"if ([1, 2].any(fn(x) => x > 1) && ![1].contains(7)) { print(\"yes\") }", "yes\n"},
    {"for (p in zip([1, 2], [3, 4]).filter(fn(p) => p.first > 1)) { print(p.second) }", "4\n"},
};

}  // namespace

TEST_CASE("every loop gives what it promises, with and without optimisation") {
  for (const Case& c : kCases) {
    CAPTURE(c.text);
    CHECK(run(c.text, false).printed == c.printed);
    CHECK(run(c.text, true).printed == c.printed);
  }
}

TEST_CASE("a pass is one step and its call another, however it is compiled") {
  for (const Case& c : kCases) {
    CAPTURE(c.text);
    CHECK(run(c.text, false).result.steps == run(c.text, true).result.steps);
  }
  const std::uint64_t ten =
      run("print([1, 2, 3, 4, 5, 6, 7, 8, 9, 10].map(fn(x) => x))", true).result.steps;
  const std::uint64_t five = run("print([1, 2, 3, 4, 5].map(fn(x) => x))", true).result.steps;
  CHECK(ten - five == 10);
}

TEST_CASE("the limit of steps is exact inside a loop") {
  for (const Case& c : kCases) {
    CAPTURE(c.text);
    const std::uint64_t steps = run(c.text, true).result.steps;
    for (std::uint64_t limit = 0; limit < steps; ++limit) {
      const ScriptRun short_run = run(c.text, true, {.steps = limit});
      REQUIRE(short_run.result.error.has_value());
      CHECK(short_run.result.error->code == "R0622");
    }
    CHECK(run(c.text, true, {.steps = steps}).result.status == Progress::kDone);
  }
}

// Vm checks at its end that every object was released.
TEST_CASE("running out of memory anywhere in a loop leaves nothing behind") {
  for (const Case& c : kCases) {
    CAPTURE(c.text);
    int failed = 0;
    for (std::uint64_t limit = 0; limit < 4096; limit += 16) {
      const ScriptRun tight = run(c.text, true, {.heap_bytes = limit});
      if (!tight.result.error) break;
      CHECK(tight.result.error->code == "R0628");
      ++failed;
    }
    CHECK(failed > 0);
    CHECK(failed < 256);
  }
}

TEST_CASE("an error inside leaves the loop, and half a list is dropped") {
  const std::string text =
      "try { print([\"4\", \"-1\"].map(fn(s) { if (s == \"-1\") { throw error(\"no\") }\n"
      " return s + s })) } catch (e) { print(e.message, e.line) }";
  CHECK(run(text, true).printed == "no 1\n");
  CHECK(run(text, false).printed == "no 1\n");
  const ScriptRun failed = run("let xs = [1.0, -1.0]\nprint(xs.map(fn(x) => sqrt(x)))", true);
  REQUIRE(failed.result.error.has_value());
  CHECK(failed.result.error->code == "R0609");
  REQUIRE(failed.result.error->when.has_value());
  CHECK(failed.result.error->when->calls.front() == "lambda on line 2, called on line 2");
}

TEST_CASE("lists of different length are not zipped") {
  const ScriptRun failed = run("let xs = [1]\nprint(zip(xs, [1, 2]))", true);
  REQUIRE(failed.result.error.has_value());
  CHECK(failed.result.error->code == "R0613");
}

TEST_CASE("what is not a number has no order") {
  const ScriptRun failed = run("print([1.0, 2.0].sort(by: fn(x) => 0.0 / 0.0))", true);
  REQUIRE(failed.result.error.has_value());
  CHECK(failed.result.error->code == "R0612");
}

}  // namespace armlet::lang
