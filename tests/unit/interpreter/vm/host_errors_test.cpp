// What hosts do wrong: an ArgumentError, or a failure that the program can handle.

#include <doctest/doctest.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/engine.hpp"
#include "armlet/interpreter/script_function.hpp"

namespace armlet {
namespace {

Obj* kept = nullptr;  // a function value that a native function was given
Vm* its_vm = nullptr;

// What the host's call of it throws; empty: nothing.
std::string thrown_by_calling(Vm& vm, Obj* function, std::span<const Slot> arguments) {
  Slot result{.i = 0};
  try {
    (void)vm.call(function, arguments, result);
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return {};
}

Signal throws(Vm&, Slot* args) {
  if (args[0].i == 0) return give(args, std::int64_t{0});
  if (args[0].i == 1) throw std::runtime_error("the gripper is on fire");
  if (args[0].i == 2) throw std::bad_alloc();
  throw 3;
}
double throws_directly(double x) {
  if (x > 1.0) throw std::domain_error("too far");
  return x;
}
Signal throws_real(Vm&, Slot* args) { return give(args, throws_directly(args[0].d)); }

class Broken final : public Waiting {
 public:
  explicit Broken(Timeline& timeline) : timeline_(timeline), start_(timeline.now_ns()) {}
  [[nodiscard]] std::int64_t due_ns() const override { return start_ + 1'000'000; }
  [[nodiscard]] bool is_over() const override { return timeline_.now_ns() >= due_ns(); }
  void stop() override {}
  Signal finish(Vm&, Slot&) override { throw std::runtime_error("the motor is gone"); }
  [[nodiscard]] std::string what() const override { return "nothing"; }

 private:
  Timeline& timeline_;
  std::int64_t start_;
};
Signal breaks_later(Vm& vm, Slot*) { return pause(vm, std::make_unique<Broken>(vm.timeline())); }
Signal pauses_for_nothing(Vm&, Slot*) { return Signal::kPause; }
Signal fails_silently(Vm&, Slot*) { return Signal::kFail; }

Signal keep(Vm& vm, Slot* args) {
  kept = args[0].o;
  its_vm = &vm;
  return give_nothing();
}
Signal call_with_two(Vm& vm, Slot* args) {
  const Slot two[] = {slot_of(1.0), slot_of(2.0)};
  Slot result{.i = 0};
  if (!vm.call(args[0].o, two, result)) return Signal::kFail;
  return give(args, result.d);
}
Signal call_null(Vm& vm, Slot* args) {
  Slot result{.i = 0};
  if (!vm.call(nullptr, {args, 1}, result)) return Signal::kFail;
  return give(args, result.d);
}
Signal call_text(Vm& vm, Slot* args) {
  Slot result{.i = 0};
  return vm.call(args[0].o, {}, result) ? give_nothing() : Signal::kFail;
}
Signal call_as_ints(Vm& vm, Slot* args) {
  const ScriptFunction<std::int64_t(std::int64_t)> f(vm, args[0]);
  std::int64_t result = 0;
  return f.call(result, 1) ? give(args, 0.0) : Signal::kFail;
}
Signal call_as_two(Vm& vm, Slot* args) {
  const ScriptFunction<double(double, double)> f(vm, args[0]);
  double result = 0.0;
  return f.call(result, 1.0, 2.0) ? give(args, result) : Signal::kFail;
}
Signal call_elsewhere(Vm& vm, Slot* args) {
  std::string said;
  std::thread other([&] {
    const Slot one[] = {slot_of(1.0)};
    said = thrown_by_calling(vm, args[0].o, one);
  });
  other.join();
  return give(args, new_text(vm, said));
}
Signal call_once(Vm& vm, Slot* args) {
  const ScriptFunction<double(double)> f(vm, args[0]);
  double result = 0.0;
  return f.call(result, 2.0) ? give(args, result) : Signal::kFail;
}

constexpr NativeFunction kFunctions[] = {
    {.name = "throws", .signature = "(how: int) -> int", .thunk = throws},
    {.name = "throwsReal",
     .signature = "(x: double) -> double",
     .thunk = throws_real,
     .real1 = throws_directly},
    {.name = "breaksLater", .signature = "()", .thunk = breaks_later, .pauses = true},
    {.name = "pausesForNothing", .signature = "()", .thunk = pauses_for_nothing, .pauses = true},
    {.name = "failsSilently", .signature = "()", .thunk = fails_silently},
    {.name = "keep", .signature = "(f: fn(double) -> double)", .thunk = keep},
    {.name = "callWithTwo",
     .signature = "(f: fn(double) -> double) -> double",
     .thunk = call_with_two},
    {.name = "callNull", .signature = "(f: fn(double) -> double) -> double", .thunk = call_null},
    {.name = "callText", .signature = "(f: string)", .thunk = call_text},
    {.name = "callAsInts",
     .signature = "(f: fn(double) -> double) -> double",
     .thunk = call_as_ints},
    {.name = "callAsTwo", .signature = "(f: fn(double) -> double) -> double", .thunk = call_as_two},
    {.name = "callElsewhere",
     .signature = "(f: fn(double) -> double) -> string",
     .thunk = call_elsewhere},
    {.name = "callOnce", .signature = "(f: fn(double) -> double) -> double", .thunk = call_once},
};

std::shared_ptr<const Program> compiled(const std::string& text) {
  Engine engine;
  engine.add_functions(kFunctions);
  Compilation compilation = engine.compile(text, "host.rbt");
  for (const Diagnostic& d : compilation.diagnostics) CAPTURE(d.message);
  REQUIRE(compilation.program != nullptr);
  return compilation.program;
}

struct Outcome {
  std::string printed;
  std::string error;  // code and headline
};

Outcome run(const std::string& text, VmOptions options = {}) {
  Outcome outcome;
  options.output = [&](std::string_view part) { outcome.printed += part; };
  Vm vm(compiled(text), std::move(options));
  const RunResult result = vm.run();
  if (result.error) outcome.error = result.error->code + ": " + result.error->message;
  return outcome;
}

// What catch sees of the failure of one statement, and whether finally ran.
std::string caught(const std::string& statement) {
  return run("try {\n  try { " + statement + " } finally { print(\"finally\") }\n" +
             "} catch (e) { print(e.kind, e.message) }\nprint(\"on\")\n")
      .printed;
}

// A clock that breaks once, at 1 s.
class BrokenClock final : public Timeline {
 public:
  [[nodiscard]] std::int64_t now_ns() const override { return now_ns_; }
  [[nodiscard]] std::int64_t tick_ns() const override { return 1'000'000; }
  bool advance_to(std::int64_t t_ns) override {
    if (t_ns >= 1'000'000'000 && !broken_) {
      broken_ = true;
      throw std::runtime_error("the clock stands still");
    }
    now_ns_ = t_ns;
    return true;
  }

 private:
  std::int64_t now_ns_ = 0;
  bool broken_ = false;
};

}  // namespace

TEST_CASE("a Vm without a program is refused") {
  CHECK_THROWS_AS(Vm(nullptr, {}), ArgumentError);
  const Engine engine;
  CHECK_THROWS_AS(Vm(engine.compile("let = 3", "p.rbt").program, {}), ArgumentError);
}

TEST_CASE("what native functions throw is a failure of kind Host: catch and finally run") {
  CHECK(caught("print(throws(0))") == "0\nfinally\non\n");
  CHECK(caught("print(throws(1))") ==
        "finally\nHost `throws` failed: the gripper is on fire\non\n");
  CHECK(caught("print(throws(2))") ==
        "finally\nHost `throws` failed: there is not enough memory\non\n");
  CHECK(caught("print(throws(3))") ==
        "finally\nHost `throws` failed: it threw what is no std::exception\non\n");
  CHECK(run("let a = 1\nprint(throws(a))").error ==
        "R0626: `throws` failed: the gripper is on fire");
}

TEST_CASE("what is thrown through calls of the program by the host is caught where it belongs") {
  const std::string inner =
      "fn f(x: double) -> double {\n  try { return double(throws(1)) }"
      " catch (e) { print(e.message) }\n  return x }\n";
  CHECK(run(inner + "print(callOnce(f))").printed ==
        "`throws` failed: the gripper is on fire\n2.0\n");
  const std::string outer =
      "fn f(x: double) -> double {\n  let s = [x, x]\n"
      "  try { return double(throws(1)) + s[0] } finally { print(\"inner\") } }\n";
  CHECK(
      run(outer + "for (i in range(3)) { try { print(callOnce(f)) } catch (e) { print(e.kind) } }")
          .printed == "inner\nHost\ninner\nHost\ninner\nHost\n");
}

TEST_CASE("a direct call that throws gives back what the frames above it hold") {
  const std::string text =
      "fn deep(n: int, s: string) -> double {\n  let own = s + \"x\"\n"
      "  if (n > 0) { return deep(n - 1, own) }\n  return throwsReal(double(own.length)) }\n"
      "for (i in range(3)) { try { print(deep(20, \"a\")) } catch (e) { print(e.message, e.line) } "
      "}\n";
  const Outcome outcome = run(text);
  const std::string once = "`throwsReal` failed: too far 4\n";
  CHECK(outcome.printed == once + once + once);
  CHECK(outcome.error.empty());
}

TEST_CASE("what is thrown at the end of a wait, or by the clock, reaches the program too") {
  CHECK(caught("breaksLater()") == "finally\nHost `breaksLater` failed: the motor is gone\non\n");
  BrokenClock clock;
  VmOptions options;
  options.timeline = &clock;
  const Outcome outcome =
      run("try { wait(2s) } catch (e) { print(e.kind, e.message) }\nwait(2s)\nprint(now_is())\n"
          "fn now_is() => \"on\"\n",
          std::move(options));
  CHECK(outcome.printed == "Host a function of the host failed: the clock stands still\non\n");
}

TEST_CASE("signals that say what is not so are failures of kind Host") {
  CHECK(caught("pausesForNothing()") ==
        "finally\nHost a function of the host waits for nothing\non\n");
  CHECK(caught("failsSilently()") ==
        "finally\nHost `failsSilently` failed and did not say why\non\n");
}

TEST_CASE("output that throws ends the program cleanly") {
  VmOptions options;
  Vm vm(compiled("print(1)"),
        {.output = [](std::string_view) { throw std::runtime_error("gone"); }});
  const RunResult result = vm.run();
  REQUIRE(result.error);
  CHECK(result.error->code == "R0626");
  CHECK(result.error->message.find("gone") != std::string::npos);
}

TEST_CASE("functions of a program are called as they are declared") {
  const std::string f = "fn half(x: double) -> double { return 0.5 * x }\n";
  const auto said = [&](const std::string& call) {
    return run(f + "try { print(" + call + ") } catch (e) { print(e.kind, e.message) }").printed;
  };
  CHECK(said("callOnce(half)") == "1.0\n");
  CHECK(said("callWithTwo(half)") ==
        "Host `callWithTwo` failed: `half` has 1 parameters; it was called with 2 arguments.\n");
  CHECK(said("callAsTwo(half)") ==
        "Host `callAsTwo` failed: `half` has 1 parameters; it was called with 2 arguments.\n");
  CHECK(
      said("callAsInts(half)") ==
      "Host `callAsInts` failed: `half` has other types than the ScriptFunction that calls it.\n");
  CHECK(said("callNull(half)") ==
        "Host `callNull` failed: What is to be called is no function value of the program.\n");
  CHECK(run("try { callText(\"a\") } catch (e) { print(e.message) }").printed ==
        "`callText` failed: What is to be called is no function value of the program.\n");
}

TEST_CASE("functions of a program are called by its own thread, while it runs") {
  CHECK(run("print(callElsewhere(fn(x) => x))").printed ==
        "Functions of a program can be called only by the thread that runs it.\n");
  const std::shared_ptr<const Program> program = compiled("keep(fn(x) => x)");
  Vm vm(program, {});
  const Slot one[] = {slot_of(1.0)};
  const std::string idle = "Functions of a program can be called only while it runs.";
  CHECK(thrown_by_calling(vm, nullptr, one) == idle);
  CHECK(vm.run().status == Progress::kDone);
  CHECK(its_vm == &vm);
  CHECK(thrown_by_calling(vm, kept, one) == idle);
}

TEST_CASE("an engine takes each name once") {
  static constexpr NativeFunction kTwice[] = {
      {.name = "f", .signature = "(x: double) -> double", .thunk = throws_real},
      {.name = "f", .signature = "(x: double) -> double", .thunk = throws_real}};
  static constexpr NativeConstant kConstants[] = {{"TAU", 6.25, dims::kNone, "A turn."}};
  static const HostType type{.name = "thing"};
  Engine engine;
  engine.add_functions(kFunctions)
      .add_constants(kConstants)
      .add_type(type)
      .add_record("Pair", "a: int");
  CHECK_THROWS_WITH_AS(engine.add_functions(kFunctions),
                       "The function `throws(how: int) -> int` is known to this engine already.",
                       ArgumentError);
  CHECK_THROWS_AS(engine.add_functions(kTwice), ArgumentError);
  CHECK_THROWS_AS(engine.add_constants(kConstants), ArgumentError);
  CHECK_THROWS_AS(engine.add_type(type), ArgumentError);
  CHECK_THROWS_AS(engine.add_record("Pair", "b: int"), ArgumentError);
  CHECK_THROWS_AS(engine.add_record("error", "b: int"), ArgumentError);
  CHECK(engine.compile("print(f(1.0))", "p.rbt").program == nullptr);  // nothing was added
  CHECK(engine.compile("print(throws(0), TAU)", "p.rbt").program != nullptr);
}

TEST_CASE("an engine that has been moved from says so") {
  Engine from;
  const Engine to = std::move(from);
  CHECK(to.compile("print(1)", "here.rbt").program != nullptr);
  CHECK_THROWS_WITH_AS(static_cast<void>(from.compile("print(1)", "gone.rbt")),
                       doctest::Contains("moved from"), ArgumentError);
  CHECK_THROWS_AS(static_cast<void>(from.check_signatures()), ArgumentError);
}

TEST_CASE("a loader that throws is why a file cannot be imported") {
  const Engine engine;
  CompileOptions options;
  options.load = [](const std::string&, const std::string&) -> ImportedText {
    throw std::runtime_error("the disk is on fire");
  };
  const std::string shown = engine.compile("import \"a.rbt\" as a", "main.rbt", options).text();
  CHECK_MESSAGE(shown.find("the disk is on fire") != std::string::npos, shown);
  CHECK_MESSAGE(shown.find("Armlet itself") == std::string::npos, shown);
}

}  // namespace armlet

TEST_CASE("a run that fails says why, as a whole and in slices") {
  const Engine engine;
  const auto program =
      engine.compile("let xs = [1]\nprint(xs[3 + xs.length])\n", "bad.rbt").program;
  REQUIRE(program != nullptr);
  Vm whole(program);
  CHECK(whole.error() == nullptr);
  REQUIRE(whole.run().status == Progress::kFailed);
  REQUIRE(whole.error() != nullptr);
  CHECK(whole.error()->code == "R0606");
  CHECK(whole.error_text().find("bad.rbt:2:7") != std::string::npos);
  Vm sliced(program);
  Progress progress = Progress::kPaused;
  while (progress == Progress::kPaused) progress = sliced.run(Budget{.steps = 2});
  CHECK(progress == Progress::kFailed);
  CHECK(sliced.error_text() == whole.error_text());
}
