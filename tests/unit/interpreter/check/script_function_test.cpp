// Calls in both directions between a program and its host, and what they count.

#include "armlet/interpreter/script_function.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "armlet/interpreter/engine.hpp"

namespace armlet {
namespace {

// sumOf(f, n): f(0) + f(1) + ... + f(n - 1).
Signal sum_of(Vm& vm, Slot* args) {
  const ScriptFunction<double(std::int64_t)> f(vm, args[0]);
  double sum = 0.0;
  for (std::int64_t i = 0; i < args[1].i; ++i) {
    double value = 0.0;
    if (!f.call(value, i)) return Signal::kFail;
    sum += value;
  }
  return give(args, sum);
}

// firstWhere(f): the first of 0, 1, 2 ... for which f is true.
Signal first_where(Vm& vm, Slot* args) {
  const ScriptFunction<bool(double)> f(vm, args[0]);
  double x = -1.0;
  bool found = false;
  do {
    x += 1.0;
    if (!f.call(found, x)) return Signal::kFail;
  } while (!found);
  return give(args, x);
}

// both(f, g, x): f(x) - g(x, x) + f(g(x, 1)), the two in turn.
Signal both(Vm& vm, Slot* args) {
  const ScriptFunction<double(double)> f(vm, args[0]);
  const ScriptFunction<double(double, double)> g(vm, args[1]);
  const double x = args[2].d;
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;
  const bool done = f.call(a, x) && g.call(b, x, x) && g.call(c, x, 1.0) && f.call(c, c);
  return done ? give(args, a - b + c) : Signal::kFail;
}

double middle_of(double x, double low, double high) {
  return low <= high ? std::fmin(std::fmax(x, low), high) : std::nan("");
}

Signal middle(Vm& vm, Slot* args) {
  const double found = middle_of(args[0].d, args[1].d, args[2].d);
  if (std::isnan(found))
    return fail(vm, {.headline = Headline::own("R0609", "the ends are turned")});
  return give(args, found);
}

constexpr NativeFunction kFunctions[] = {
    {.name = "sumOf", .signature = "(f: fn(int) -> double, n: int) -> double", .thunk = sum_of},
    {.name = "firstWhere", .signature = "(f: fn(double) -> bool) -> double", .thunk = first_where},
    {.name = "both",
     .signature = "(f: fn(double) -> double, g: fn(double, double) -> double, x: double) -> double",
     .thunk = both},
    {.name = "middle",
     .signature = "(x: double, low: double, high: double) -> double",
     .thunk = middle,
     .real3 = middle_of},
};

struct Outcome {
  std::string printed;
  std::string error;  // its code
  std::uint64_t steps = 0;
  std::string code;  // of the machine
};

Outcome outcome_of(const std::string& text, const RunLimits& limits = {}) {
  Engine engine;
  engine.add_functions(kFunctions);
  const Compilation compilation = engine.compile(text, "calls.rbt");
  REQUIRE(compilation.program != nullptr);
  Outcome outcome;
  VmOptions options;
  options.limits = limits;
  options.output = [&](std::string_view printed) { outcome.printed += printed; };
  Vm vm(compilation.program, std::move(options));
  const RunResult result = vm.run();
  if (result.error) outcome.error = result.error->code;
  outcome.steps = result.steps;
  outcome.code = compilation.program->disassemble();
  return outcome;
}

TEST_CASE("a host calls functions of the program with doubles, ints and truth values") {
  CHECK(outcome_of("print(sumOf(fn(i) => i * 0.5, 5))").printed == "5.0\n");
  CHECK(outcome_of("print(firstWhere(fn(x) => x * x > 10.0))").printed == "4.0\n");
  CHECK(outcome_of("print(both(fn(x) => x * 2.0, fn(x, y) => x + y, 3.0))").printed == "8.0\n");
}

TEST_CASE("calls by the host may hold lists, capture values and call the host again") {
  CHECK(outcome_of("let scale = [2.0, 3.0]\n"
                   "fn f(i: int) -> double {\n  var xs = [1.0, 2.0]\n  xs.push(scale[i % 2])\n"
                   "  return xs[2] }\nprint(sumOf(f, 4))")
            .printed == "10.0\n");
  CHECK(outcome_of("print(sumOf(fn(i) => sumOf(fn(j) => double(j), i), 5))").printed == "10.0\n");
}

TEST_CASE("what fails in a function called by the host can be caught around the host's function") {
  const Outcome caught = outcome_of(
      "fn f(i: int) -> double { if (i == 3) { throw error(\"three\") }\n  return 1.0 }\n"
      "for (k in range(3)) { try { print(sumOf(f, 10)) } catch (e) { print(e.message) } }\n"
      "print(sumOf(f, 3))");
  CHECK(caught.printed == "three\nthree\nthree\n3.0\n");
  CHECK(caught.error.empty());
}

TEST_CASE("calls through the host end at the depth of calls like others") {
  const std::string endless = "fn f(i: int) -> double { return sumOf(f, 1) }\nprint(sumOf(f, 1))";
  CHECK(outcome_of(endless).error == "R0624");
  RunLimits shallow;
  shallow.call_depth = 50;
  CHECK(outcome_of(endless, shallow).error == "R0624");
}

TEST_CASE("every call by the host is one step") {
  const auto steps = [](int calls) {
    return outcome_of("print(sumOf(fn(i) => 1.0, " + std::to_string(calls) + "))").steps;
  };
  CHECK(steps(1000) - steps(10) == 990);
  CHECK(outcome_of("print(sumOf(fn(i) => 1.0, 1000))", {.steps = 500}).error == "R0622");
}

TEST_CASE("functions of three doubles are called directly, and asked why when they fail") {
  const Outcome direct = outcome_of(
      "var x = 0.0\nfor (i in range(5)) { x += middle(x * 2.0, 1.0, i + 2.0) }\nprint(x)");
  CHECK(direct.printed == "18.0\n");
  CHECK(direct.code.find("CALLD3") != std::string::npos);
  const Outcome failed = outcome_of(
      "var low = 2.0\ntry { print(middle(1.0, low, 1.5)) } catch (e) { print(e.message) }");
  CHECK(failed.printed == "the ends are turned\n");
}

}  // namespace
}  // namespace armlet
