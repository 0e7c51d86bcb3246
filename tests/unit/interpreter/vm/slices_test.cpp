// A run in slices is the run in one piece.
#include <doctest/doctest.h>

#include <string>
#include <thread>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "vm_fixture.hpp"

using namespace armlet;
using namespace armlet::lang;

namespace {

// What a run shows of itself.
struct Shown {
  std::string output;
  std::string error;
  std::uint64_t steps = 0;
  Progress status = Progress::kPaused;
  bool operator==(const Shown&) const = default;
};

struct SlicedRun {
  Shown shown;
  int slices = 0;
};

// next  the budget of the next slice.
template <class Next>
SlicedRun run_in_slices(const std::shared_ptr<const Program>& program, Next next,
                        RunLimits limits = {}) {
  SlicedRun run;
  VmOptions options;
  options.limits = limits;
  options.output = [&](std::string_view text) { run.shown.output += text; };
  Vm vm(program, options);
  do {
    ++run.slices;
  } while (vm.run(next(vm)) == Progress::kPaused);
  const RunResult& result = vm.result();
  run.shown.status = result.status;
  run.shown.steps = result.steps;
  if (result.error) run.shown.error = result.error->code + " " + result.error->message;
  return run;
}

Budget whole(const Vm&) { return {}; }
Budget one_step(const Vm&) { return {.until_ns = {}, .steps = 1}; }
Budget a_millisecond(Vm& vm) { return {.until_ns = vm.timeline().now_ns() + 1'000'000}; }

// Programs in which something is running wherever a slice ends.
const std::vector<std::string> kPrograms = {
    // Sums that loops keep in the processor from pass to pass.
    R"(
var s = 0.0
let xs = [0.1, 0.2, 0.3, 0.4, 0.5]
for (r in range(50)) { for (x in xs) { s = s + x } }
print(s))",
    R"(
var s = 1.0
for (i in range(1000)) { s = s * 0.999 + 0.5 }
print(s))",
    R"(
let a = [[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]]
var s = 0.0
for (i in range(3)) { for (j in range(2)) { s = s + a[i][j] * a[i][1] } }
print(s))",
    R"(
fn dot(x: double[], y: double[]) -> double {
    var s = 0.0
    for (i in range(x.length)) { s = s + x[i] * y[i] }
    return s
}
print(dot([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0], [4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 0.1])))",
    // Calls inside of calls, of the program and of the host.
    R"(
fn fib(n: int) -> int { if (n < 2) return n
    return fib(n - 1) + fib(n - 2) }
print(fib(12)))",
    R"(
fn sum(x: double) -> double {
    var s = 0.0
    for (i in range(9)) { s = s + x }
    return s
}
for (i in range(3)) { print(map([1.0, 4.0, 9.0], sum)) })",
    // Failures being handled.
    R"(
fn deep(n: int) -> int { if (n == 0) throw error("down")
    return deep(n - 1) }
for (i in range(5)) {
    try { print(deep(i)) } catch (e) { print(e.message) } finally { for (k in range(3)) { print(k) } }
})",
    R"(
let xs = [1, 2, 3, 4, 5, 6, 7]
var s = 0
for (i in range(9)) { s += xs[i] }
print(s))",
    // Tasks.
    R"(
parallel {
    { for (i in range(5)) { wait(0.3ms); print("a", i) } }
    { for (i in range(4)) { wait(0.7ms); print("b", i) } }
}
print(now()))",
    R"(
var n = 0
when (n == 3) { for (i in range(3)) { print("three", i, now()) } }
every (1ms) {
    n += 1
    for (i in range(3)) { n += 0 }
}
wait(7.5ms)
print(n, now()))",
    R"(
var n = 0
parallel {
    { while (n < 20) { n += 1; wait(0.1ms) } }
    { wait until n >= 10; print("ten", now()) }
}
wait(2h)
print(now()))",
};

}  // namespace

TEST_CASE("a run in slices is the run in one piece") {
  for (const std::string& text : kPrograms) {
    CAPTURE(text);
    const auto program = compiled(text);
    const SlicedRun run = run_in_slices(program, whole);
    CHECK(run.slices == 1);
    const SlicedRun by_step = run_in_slices(program, one_step);
    CHECK(by_step.shown == run.shown);
    // What a function of the host calls is finished.
    if (text.find("map(") == std::string::npos) CHECK(by_step.slices > 4);
    Random random(7);
    CHECK(run_in_slices(program, [&](Vm& vm) {
            Budget budget{.until_ns = {}, .steps = 1 + random.next() % 30};
            if (random.next() % 2 == 0)
              budget.until_ns =
                  vm.timeline().now_ns() + static_cast<std::int64_t>(random.next() % 700'000);
            return budget;
          }).shown == run.shown);
    if (text.find("2h") == std::string::npos)
      CHECK(run_in_slices(program, a_millisecond).shown == run.shown);
  }
}

TEST_CASE("a slice of n steps takes n steps") {
  const auto program = compiled("var n = 0\nwhile (n < 1000) { n += 1 }");
  Vm vm(program, {});
  for (std::uint64_t steps = 10; steps <= 900; steps += 10) {
    REQUIRE(vm.run({.until_ns = {}, .steps = 10}) == Progress::kPaused);
    REQUIRE(vm.result().steps == steps);
  }
  CHECK(vm.run().status == Progress::kDone);
}

TEST_CASE("a slice until a time does what happens at that time, and brings the clock there") {
  std::string output;
  VmOptions options;
  options.output = [&](std::string_view text) { output += text; };
  Vm vm(compiled("wait(1s)\nprint(1)\nwait(1s)\nprint(2)"), options);
  CHECK(vm.run({.until_ns = 999'999'999}) == Progress::kPaused);
  CHECK(output.empty());
  CHECK(vm.timeline().now_ns() == 999'999'999);
  CHECK(vm.run({.until_ns = 1'000'000'000}) == Progress::kPaused);
  CHECK(output == "1\n");
  CHECK(vm.run({.until_ns = 500'000'000}) == Progress::kPaused);
  CHECK(vm.timeline().now_ns() == 1'000'000'000);
  CHECK(vm.run({.until_ns = 5'000'000'000}) == Progress::kDone);
  CHECK(vm.timeline().now_ns() == 2'000'000'000);
}

TEST_CASE("limits do not depend on slices") {
  const auto program = compiled("var n = 0\nwhile (true) { n += 1 }");
  RunLimits limits;
  limits.steps = 10'000;
  const Shown run = run_in_slices(program, whole, limits).shown;
  CHECK(run.error.substr(0, 5) == "R0622");
  CHECK(run_in_slices(program, one_step, limits).shown == run);
}

TEST_CASE("a paused run can be cancelled") {
  Vm vm(compiled("try { while (true) { } } finally { print(1) }"), {});
  REQUIRE(vm.run({.until_ns = {}, .steps = 100}) == Progress::kPaused);
  vm.cancel();
  CHECK(vm.run({.until_ns = {}, .steps = 100}) == Progress::kCancelled);
}

TEST_CASE("a paused run can be given up") {
  for (const std::string& text : kPrograms) {
    for (std::uint64_t steps : {1, 5, 17}) {
      Vm vm(compiled(text), {});
      static_cast<void>(vm.run({.until_ns = {}, .steps = steps}));
    }
  }
}

TEST_CASE("a budget that lets nothing happen and a run that is over are refused") {
  Vm vm(compiled("for (i in range(9)) { }"), {});
  CHECK_THROWS_WITH_AS(vm.run({.until_ns = {}, .steps = 0}),
                       "A budget of 0 steps lets nothing happen; give at least 1 step.",
                       ArgumentError);
  CHECK(vm.result().status == Progress::kPaused);
  CHECK(vm.run({.until_ns = {}, .steps = 4}) == Progress::kPaused);
  CHECK(vm.run(Budget{}) == Progress::kDone);
  CHECK_THROWS_WITH_AS(vm.run(Budget{}), "This Vm has run to its end; make a new one to run again.",
                       ArgumentError);
  CHECK(vm.result().status == Progress::kDone);
}

TEST_CASE("a function of the host cannot run the program that calls it") {
  static std::string said;
  static constexpr NativeFunction kAgain[] = {
      {.name = "again", .signature = "()", .thunk = [](Vm& vm, Slot*) {
         try {
           vm.run(Budget{});
         } catch (const ArgumentError& error) {
           said = error.what();
         }
         std::thread other([&vm] {
           try {
             vm.run(Budget{});
           } catch (const ArgumentError& error) {
             said += std::string(" ") + error.what();
           }
         });
         other.join();
         return give_nothing();
       }}};
  Engine engine;
  engine.add_functions(kAgain);
  Vm vm(engine.compile("again()", "test.rbt").program, {});
  CHECK(vm.run().status == Progress::kDone);
  CHECK(said ==
        "This Vm runs already: a function that it calls cannot run it. This Vm runs already, in "
        "another thread.");
}

TEST_CASE("slices may run in one thread after the other") {
  Vm vm(compiled("for (i in range(100)) { }"), {});
  REQUIRE(vm.run({.until_ns = {}, .steps = 10}) == Progress::kPaused);
  std::thread other([&vm] { CHECK(vm.run(Budget{}) == Progress::kDone); });
  other.join();
}
