// Looking inside: breakpoints, statements, moves, variables by scope, and back.
#include "armlet/interpreter/host/stepping.hpp"

#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/globals.hpp"
#include "armlet/interpreter/host/inspection.hpp"
#include "armlet/stdlib/session.hpp"
#include "library.hpp"
#include "refusal_of.hpp"

using namespace armlet;

namespace {

const char* const kStepped = R"(var total = 0
fn add(n: int, what: string) -> int {
    let twice = 2 * n
    if (n > 1) {
        let inner = [twice, n]
        total += inner[0]
    }
    return twice

}
let first = add(1, "a")
for (i in range(3)) {
    let square = i * i
    total += add(i, "b")
}
moveJ(home() + [0.1, 0, 0, 0], time: 1s)
parallel {
    { wait(100ms); total += 1 }
    { let here = 7mm; wait(200ms); total += 1 }
}
moveJ(home(), time: 1s)
print(total)
)";

struct Debugged {
  explicit Debugged(const std::string& text, bool markers = true) {
    SessionOptions options = at_the_table();
    options.open = true;
    options.markers = markers;
    options.output = [this](std::string_view piece) {
      printed += piece;
      return std::string();
    };
    session.emplace(library_engine(), std::move(options));
    REQUIRE(session->compile(text, "p.rbt"));
  }
  Session* operator->() { return &*session; }

  // The line of the statement about to begin, of the task that runs.
  [[nodiscard]] int line() { return session->sources().position(running_at(*session->vm())).line; }
  // "twice: int = 4, n: int = 2" of the innermost call.
  [[nodiscard]] std::string variables(std::size_t task = 0, std::size_t call = 0) {
    std::string text;
    const std::vector<SeenTask> tasks = seen_tasks(*session->vm());
    for (const SeenVariable& each : tasks[task].calls[call].variables)
      text += (text.empty() ? "" : ", ") + each.name + ": " + each.type + " = " + each.value;
    return text;
  }

  // The value of the innermost expression where the text has `word`, or why there is none.
  [[nodiscard]] std::string value(std::string_view word, std::size_t offset = 0) {
    const Source& text = session->sources()[0];
    const auto at = static_cast<std::uint32_t>(text.text().find(word) + offset);
    const Result<SeenValue> seen = value_at(*session->vm(), 0, at);
    if (!seen) return seen.error().message;
    return std::string(text.slice(seen->at)) + ": " + seen->type + " = " + seen->value;
  }

  std::string printed;
  std::optional<Session> session;
};

}  // namespace

TEST_CASE("a run stops at breakpoints, with the variables that can be seen there") {
  Debugged run(kStepped);
  // Line 9 is empty: the next statement is on line 11.
  CHECK(run->set_breakpoints({{.line = 6}, {.line = 9}, {.line = 900}}) ==
        std::vector<SourceLine>{{.line = 6}, {.line = 11}});
  CHECK(run->run().status == Progress::kPaused);
  CHECK(run.line() == 11);
  CHECK(is_at_breakpoint(*run->vm()));
  CHECK(run->run().status == Progress::kPaused);
  CHECK(run.line() == 6);
  CHECK(run.variables() == "n: int = 2, what: string = b, twice: int = 4, inner: int[] = [4, 2]");
  CHECK(run.variables(0, 1) == "i: int = 2, square: int = 4");
  const SeenTask task = seen_tasks(*run->vm())[0];
  CHECK(task.calls[0].function == "add");
  CHECK(task.calls.size() == 2);
  CHECK(run->run().status == Progress::kDone);
  CHECK(run.printed == "12\n");
}

TEST_CASE("a run goes statement by statement, through calls and tasks, and back") {
  Debugged run(kStepped);
  std::vector<int> lines;
  std::vector<std::string> totals;
  while (run->run({.statements = 1}) == Progress::kPaused) {
    lines.push_back(run.line());
    CHECK(statements_begun(*run->vm()) == lines.size());
  }
  const std::string expected =
      "11 3 4 8 12 13 14 3 4 8 13 14 3 4 8 13 14 3 4 5 6 8 16 17 18 19 19 18 19 21 22 ";
  std::string shown;
  for (const int each : lines) shown += std::to_string(each) + " ";
  CHECK(shown == expected);
  CHECK(run.printed == "12\n");
  // Steps back over all statements.
  for (std::size_t left = lines.size(); left > 1; --left) {
    REQUIRE(run->step_back());
    CHECK(run.line() == lines[left - 1]);
    CHECK(statements_begun(*run->vm()) == left);
  }
  CHECK(run.printed == "12\n");
  CHECK(run->run().status == Progress::kDone);
  CHECK(run.printed == "12\n12\n");
}

TEST_CASE("a run goes move by move") {
  Debugged run(kStepped);
  CHECK(run->run_move() == Progress::kPaused);
  CHECK(run->host()->now_ns() == 1'000'000'000);
  CHECK(run.line() == 17);
  CHECK(run->run_move() == Progress::kPaused);
  CHECK(run.line() == 22);
  CHECK(run->run_move() == Progress::kDone);
}

TEST_CASE("variables of tasks are seen, with what they wait for") {
  Debugged run(kStepped);
  CHECK(run->run({.until_ns = 1'050'000'000}) == Progress::kPaused);
  const auto tasks = seen_tasks(*run->vm());
  REQUIRE(tasks.size() == 3);
  CHECK(tasks[0].waits.empty());
  CHECK(tasks[1].name == "branch 1 of parallel on line 17");
  CHECK(tasks[1].waits == "a time");
  CHECK(run.variables(2) == "here: length = 7 mm");
  const auto variables = seen_variables(*run->vm());
  CHECK(variables[0].value == "10");
}

TEST_CASE("going back keeps breakpoints, and does not stop at them") {
  Debugged run(kStepped);
  CHECK(run->set_breakpoints({{.line = 14}}).size() == 1);
  for (int i = 0; i < 3; ++i) CHECK(run->run().status == Progress::kPaused);
  CHECK(run->run().status == Progress::kDone);
  REQUIRE(run->go_to(500'000'000));
  CHECK(run->host()->now_ns() == 500'000'000);
  CHECK(run->run().status == Progress::kDone);
  CHECK(run->set_breakpoints({}).empty());
}

TEST_CASE("running by statements needs markers") {
  Debugged run(kStepped, false);
  CHECK(refusal_of([&] { run->run({.statements = 1}); }) ==
        "A run by statements needs a program that was compiled with markers.");
  CHECK(refusal_of([&] { run->set_breakpoints({{.line = 1}}); }) ==
        "Breakpoints need a program that was compiled with markers.");
  CHECK(refusal_of([&] { run->step_back(); }) != "");
  Debugged other(kStepped);
  CHECK(refusal_of([&] { other->run({.statements = 0}); }) ==
        "A budget of 0 statements lets nothing happen; give at least 1.");
  CHECK(other->run().status == Progress::kDone);
}

namespace {

const char* const kAsked = R"(var total = 0
let late = 5
fn square(x: double) -> double { return x * x }
fn count() -> int {
    total++
    return total
}
fn area(width: length, sizes: int[], name: string) -> area {
    let factor = square(2.0) + sizes[1]
    let ratios = map(sizes, fn(n: int) => factor * n)
    let label = f"{name}: {sizes.length} of {width}"
    let next = count() + sizes[7]
    let after = factor
    return width * width * after
}
print(area(30mm, [1, 2, 3], "plate"))
let end = total
)";

}  // namespace

TEST_CASE("a paused run gives the value of the expression at a position in its text") {
  Debugged run(kAsked);
  CHECK(run->set_breakpoints({{.line = 12}}).size() == 1);
  CHECK(run->run().status == Progress::kPaused);
  CHECK(run.line() == 12);
  // The variables of the function, operators, elements, fields, and functions that change nothing.
  CHECK(run.value("square(2.0) + sizes", 12) == "square(2.0) + sizes[1]: double = 6.0");
  CHECK(run.value("square(2.0) + sizes", 0) == "square(2.0): double = 4.0");
  CHECK(run.value("sizes[1]", 0) == "sizes: int[] = [1, 2, 3]");
  CHECK(run.value("sizes[1]", 5) == "sizes[1]: int = 2");
  CHECK(run.value("sizes[1]", 6) == "1: int = 1");
  CHECK(run.value("map(sizes, fn", 0) ==
        "map(sizes, fn(n: int) => factor * n): double[] = [6.0, 12.0, 18.0]");
  CHECK(run.value("f\"{name}", 0).ends_with(": string = plate: 3 of 30 mm"));
  CHECK(run.value("width * width", 6) == "width * width: area = 0.0009 m^2");
  CHECK(run.value("[1, 2, 3]", 0) == "[1, 2, 3]: int[] = [1, 2, 3]");
  // What has none.
  CHECK(run.value("sizes[7]", 5) == "This fails: list index 7 is outside 0 to 2");
  CHECK(run.value("count() +", 0) ==
        "`count` changes `total`, so it is not called to look at its value.");
  CHECK(run.value("* after", 2) == "`after` has no value here.");
  CHECK(run.value("x * x", 0) == "`x` has no value here.");
  CHECK(run.value("print(area", 0) == "What stands there gives no value.");
  CHECK(run.value("fn square", 0) == "No expression of the program stands there.");
  CHECK(run.value("end = total", 6) == "total: int = 0");
  // Nothing was changed by looking.
  CHECK(run->run().status == Progress::kFailed);
  CHECK(run->result().error->code == "R0606");
}

TEST_CASE("looking at a value leaves no trace, and acts on nothing") {
  const char* const text = R"(let arms = [1]
fn drawn() -> double { return random() }
var place = home()
moveJ(home() + [0.1, 0, 0, 0], time: 1s)
let a = drawn()
print(a)
)";
  Debugged plain(text);
  CHECK(plain->run().status == Progress::kDone);
  Debugged run(text);
  do REQUIRE(run->run({.statements = 1}) == Progress::kPaused);
  while (run.line() != 5);
  const std::string seen = run.value("drawn()\nprint", 0);
  CHECK(run.value("drawn()\nprint", 0) == seen);
  CHECK(run.value("moveJ(home", 0) ==
        "`moveJ` acts or takes time, so it is not called to look at a value.");
  CHECK(run.value("arms", 0) == "No expression of the program stands there.");
  CHECK(run->run().status == Progress::kDone);
  CHECK(run.printed == plain.printed);
  CHECK(run.value("drawn()\nprint", 0) != seen);
}
