#pragma once
// Runs small programs in tests, with a library of a few functions.

#include <cmath>
#include <string>
#include <utility>

#include "armlet/interpreter/engine.hpp"
#include "driver/pipeline.hpp"
#include "driver/vocabulary.hpp"

namespace armlet::lang {

namespace script_library {

inline Signal root(Vm& vm, Slot* args) {
  if (args[0].d < 0.0) {
    Failure failure;
    failure.headline = Headline::own("R0609", "the root of a negative number");
    return fail(vm, std::move(failure));
  }
  return give(args, std::sqrt(args[0].d));
}
inline Signal length(Vm&, Slot* args) {
  return give(args, std::sqrt(args[0].d * args[0].d + args[1].d * args[1].d));
}
// Calls a function value twice.
inline Signal twice(Vm& vm, Slot* args) {
  Slot once;
  Slot result;
  if (!vm.call(args[0].o, {&args[1], 1}, once)) return Signal::kFail;
  if (!vm.call(args[0].o, {&once, 1}, result)) return Signal::kFail;
  args[0] = result;
  return Signal::kDone;
}
inline Signal total(Vm&, Slot* args) {
  double sum = 0.0;
  for (const double x : reals_value(args[0])) sum += x;
  return give(args, sum);
}

inline const NativeFunction kFunctions[] = {
    {.name = "sqrt",
     .signature = "(x: double) -> double",
     .help = "Square root.",
     .example = "sqrt(2.0)",
     .thunk = &root,
     .real1 = [](double x) { return std::sqrt(x); }},
    {.name = "hypot",
     .signature = "(a: double, b: double) -> double",
     .help = "Length of a vector.",
     .example = "hypot(3.0, 4.0)",
     .thunk = &length,
     .real2 = [](double a, double b) { return std::sqrt(a * a + b * b); }},
    {.name = "twice",
     .signature = "(f: fn(int) -> int, x: int) -> int",
     .help = "f(f(x)).",
     .example = "twice(fn(n) => n + 1, 3)",
     .thunk = &twice},
    {.name = "sum",
     .signature = "(xs: double[]) -> double",
     .help = "The sum.",
     .example = "sum([1.0])",
     .thunk = &total},
};

}  // namespace script_library

inline const Engine& script_engine() {
  static const Engine engine = [] {
    Engine made;
    made.add_functions(script_library::kFunctions);
    return made;
  }();
  return engine;
}

inline Compilation compile_script(const std::string& text, bool optimise = true) {
  return compile_text(script_engine().registry(), text, "test.rbt", {.open = false},
                      {.optimise = optimise});
}

// What a program prints and how it ends, as a text.
struct ScriptRun {
  std::string printed;
  RunResult result;
};

inline ScriptRun run_compiled(std::shared_ptr<const Program> program, const RunLimits& limits) {
  ScriptRun run;
  VmOptions options;
  options.limits = limits;
  options.output = [&](std::string_view text) { run.printed += text; };
  Vm vm(std::move(program), std::move(options));
  run.result = vm.run();
  return run;
}

// What a program prints; then, on a line of its own, the code and headline of the error that ended
// it, or of the first mistake found before running.
inline std::string run_script(const std::string& text, bool optimise = true) {
  const Compilation compilation = compile_script(text, optimise);
  if (compilation.program == nullptr) {
    const Diagnostic& first = compilation.diagnostics.at(0);
    return first.code + " " + first.message + "\n";
  }
  ScriptRun run = run_compiled(compilation.program, {});
  if (run.result.error.has_value()) {
    run.printed += run.result.error->code + " " + run.result.error->message + "\n";
  }
  return run.printed;
}

// All that a program shows, together with its steps and where it failed: marks, calls and passes.
inline std::string trace_script(const std::string& text, bool optimise,
                                const RunLimits& limits = {}) {
  const Compilation compilation = compile_script(text, optimise);
  if (compilation.program == nullptr) return compilation.diagnostics.at(0).message;
  ScriptRun run = run_compiled(compilation.program, limits);
  std::string& out = run.printed;
  out += std::to_string(run.result.steps) + " steps\n";
  if (!run.result.error.has_value()) return out;
  const Diagnostic& error = *run.result.error;
  out += error.code + " " + error.message + " at " + std::to_string(error.mark.span.begin) +
         " to " + std::to_string(error.mark.span.end) + " " + error.mark.label + "\n" + error.why +
         "\n";
  if (!error.when.has_value()) return out;
  out += error.when->note + "\n";
  for (const std::string& call : error.when->calls) out += call + "\n";
  return out;
}

}  // namespace armlet::lang
