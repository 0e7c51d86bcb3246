#pragma once
// Compiles a text, runs it with a few native functions, and keeps what it wrote.

#include <doctest/doctest.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "armlet/interpreter/engine.hpp"

namespace armlet::lang {

// A motion of the test vocabulary: it stops at once on request.
class TestMotion final : public Waiting {
 public:
  TestMotion(Timeline& timeline, double seconds)
      : timeline_(timeline),
        due_ns_(timeline.now_ns() + static_cast<std::int64_t>(seconds * 1e9)) {}

  [[nodiscard]] std::int64_t due_ns() const override { return due_ns_; }
  [[nodiscard]] bool is_over() const override { return timeline_.now_ns() >= due_ns_; }
  void stop() override {
    stopped_ = true;
    due_ns_ = timeline_.now_ns();
  }
  Signal finish(Vm&, Slot& result) override { return give(&result, !stopped_); }
  [[nodiscard]] std::string what() const override { return "move"; }

 private:
  Timeline& timeline_;
  std::int64_t due_ns_;
  bool stopped_ = false;
};

inline double square_root(double x) { return __builtin_sqrt(x); }

inline Signal sqrt_of(Vm& vm, Slot* args) {
  if (args[0].d >= 0.0) return give(args, square_root(args[0].d));
  return fail(
      vm, {.headline = {"R0609", {"sqrt", "a negative number", "the value must not be negative"}},
           .mark = at("x"),
           .fix = "use sqrt(abs({arg}))"});
}

inline Signal move(Vm& vm, Slot* args) {
  return pause(vm, std::make_unique<TestMotion>(vm.timeline(), args[0].d));
}

inline Signal now(Vm& vm, Slot* args) {
  return give(args, static_cast<double>(vm.timeline().now_ns()) * 1e-9);
}

inline Signal map_reals(Vm& vm, Slot* args) {
  const auto& from = *static_cast<ListObj*>(args[0].o);
  ListObj* to = new_list(vm, from.size, false);
  if (to == nullptr) return Signal::kFail;
  for (std::uint32_t i = 0; i < from.size; ++i) {
    if (!vm.call(args[1].o, {&from.data[i], 1}, to->data[i])) {
      release(vm, to);
      return Signal::kFail;
    }
  }
  return give(args, to);
}

inline constexpr HostType kArm = {.name = "robot"};

// Fails, and blames the third value of the list.
inline Signal refuse(Vm& vm, Slot*) {
  return fail(vm, {.headline = Headline::own(
                       "R0606", "joint 3 would turn to 152 deg; its range is -145 deg to 145 deg"),
                   .mark = at("xs"),
                   .mark_element = 2,
                   .fix = "the value was given on line {line}",
                   .resource = {&kArm, "arm"}});
}

inline Signal cancel_now(Vm& vm, Slot*) {
  vm.cancel();
  return give_nothing();
}

inline Signal note(Vm& vm, Slot*) {
  vm.advise({.headline = Headline::own("W0701", "a note"), .mark = CallPart::callee()});
  return give_nothing();
}

inline constexpr NativeFunction kTestFunctions[] = {
    {.name = "sqrt", .signature = "(x: double) -> double", .thunk = sqrt_of, .real1 = square_root},
    {.name = "move", .signature = "(t: double) -> bool", .thunk = move, .pauses = true},
    {.name = "now", .signature = "() -> time", .thunk = now},
    {.name = "map",
     .signature = "(xs: double[], f: fn(double) -> double) -> double[]",
     .thunk = map_reals},
    {.name = "refuse", .signature = "(xs: double[])", .thunk = refuse},
    {.name = "cancelNow", .signature = "()", .thunk = cancel_now},
    {.name = "note", .signature = "()", .thunk = note},
};

struct Outcome {
  Progress status = Progress::kDone;
  std::string output;
  std::optional<Diagnostic> error;
  std::vector<Diagnostic> advice;
  std::uint64_t steps = 0;

  [[nodiscard]] std::string code() const { return error ? error->code : ""; }
  [[nodiscard]] std::string message() const { return error ? error->message : ""; }
};

inline std::shared_ptr<const Program> compiled(const std::string& text) {
  Engine engine;
  engine.add_functions(kTestFunctions);
  const Compilation compilation = engine.compile(text, "test.rbt");
  for (const Diagnostic& d : compilation.diagnostics) {
    if (d.severity == Severity::kError) FAIL(d.code << ": " << d.message << " in\n" << text);
  }
  REQUIRE(compilation.program != nullptr);
  return compilation.program;
}

inline Outcome outcome_of(const std::shared_ptr<const Program>& program, RunLimits limits = {},
                          int test = -1) {
  Outcome outcome;
  VmOptions options;
  options.limits = limits;
  options.output = [&](std::string_view text) { outcome.output += text; };
  options.advice = [&](const Diagnostic& advice) { outcome.advice.push_back(advice); };
  Vm vm(program, options);
  RunResult result = test < 0 ? vm.run() : vm.run_test(static_cast<std::size_t>(test));
  outcome.status = result.status;
  outcome.error = std::move(result.error);
  outcome.steps = result.steps;
  return outcome;
}

inline Outcome run(const std::string& text, RunLimits limits = {}) {
  return outcome_of(compiled(text), limits);
}

// What a program that must succeed writes.
inline std::string output_of(const std::string& text) {
  const Outcome outcome = run(text);
  CHECK_MESSAGE(outcome.status == Progress::kDone, outcome.code() << ": " << outcome.message());
  return outcome.output;
}

inline std::string marked(const Outcome& outcome, const std::string& text) {
  if (!outcome.error) return {};
  const Span span = outcome.error->mark.span;
  return text.substr(span.begin, span.end - span.begin);
}

}  // namespace armlet::lang
