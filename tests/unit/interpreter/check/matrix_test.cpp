// Matrices without the library: literals, elements and parts; and what native functions may ask
// for.

#include <doctest/doctest.h>

#include <string>

#include "refused_memory.hpp"
#include "script_support.hpp"
#include "vm/state/state.hpp"

using namespace armlet;
using namespace armlet::lang;

namespace {

constexpr const char* kProgram = R"(
struct S { M: matrix; xs: double[] }
var A = [1, 2, 3; 4, 5, 6]
let before = A
A[0, 2] = 7
A[1, :] = A[0, :]
A[:, 0:2] = [10, 11; 12, 13]
A[1, 1] += 0.5
var s = S(M: A, xs: [1, 2, 3])
s.M[0, 0] = -1
s.xs[1:] = [8, 9]
var all = [A, before]
all[1][:, 1] = [20, 30]
var names = ["a", "b", "c"]
names[0:2] = names[1:3]
fn total(M: matrix) -> double {
  var sum = 0.0
  for (row in M) { for (x in row) sum += x }
  for (i in range(2)) { for (j in range(3)) sum = sum * M[i, j] + M[i, 2] }
  return sum
}
print(A, before, s, all, names, total(A), A == before, f"{A:.1f}")
)";

Signal work(Vm& vm, Slot* args) {
  if (!charge_steps(vm, static_cast<std::uint64_t>(args[0].i))) return Signal::kFail;
  return give_nothing();
}
Signal hold(Vm& vm, Slot* args) {
  const Scratch scratch(vm, static_cast<std::uint64_t>(args[0].i));
  return scratch.granted() ? give_nothing() : Signal::kFail;
}
Signal stop(Vm& vm, Slot*) {
  vm.cancel();
  return give_nothing();
}
constexpr NativeFunction kFunctions[] = {
    {.name = "work",
     .signature = "(n: int)",
     .help = "n steps.",
     .example = "work(3)",
     .thunk = work},
    {.name = "hold",
     .signature = "(n: int)",
     .help = "n bytes.",
     .example = "hold(3)",
     .thunk = hold},
    {.name = "stop", .signature = "()", .help = "Cancels.", .example = "stop()", .thunk = stop},
};

RunResult run_with_natives(const std::string& text, const RunLimits& limits) {
  static const Engine engine = [] {
    Engine made;
    made.add_functions(kFunctions);
    return made;
  }();
  Compilation compilation = compile_text(engine.registry(), text, "test.rbt", {}, {});
  REQUIRE(compilation.program != nullptr);
  return run_compiled(compilation.program, limits).result;
}

}  // namespace

TEST_CASE("matrices have the same values with and without optimisation") {
  const ScriptRun fast = run_compiled(compile_script(kProgram, true).program, {});
  const ScriptRun plain = run_compiled(compile_script(kProgram, false).program, {});
  CHECK(fast.result.status == Progress::kDone);
  CHECK(fast.printed == plain.printed);
  CHECK(
      fast.printed.starts_with("[10.0, 11.0, 7.0; 12.0, 13.5, 7.0] "
                               "[1.0, 2.0, 3.0; 4.0, 5.0, 6.0] "
                               "S(M: [-1.0, 11.0, 7.0; 12.0, 13.5, 7.0], xs: [1.0, 8.0, 9.0])"));
}

TEST_CASE("any allocation of a matrix may fail without a leak") {
  const std::uint64_t failed = runs_failed_for_memory(kProgram, 80);
  CHECK(failed > 20);
  CHECK(failed < 79);
}

TEST_CASE("steps of native functions are counted exactly, in whole chunks and across them") {
  for (const std::int64_t n : {1, 100, 4095, 4096, 4097, 100'000}) {
    const std::string text = "work(" + std::to_string(n) + ")\nwork(" + std::to_string(n) + ")";
    const auto twice = static_cast<std::uint64_t>(2 * n);
    CHECK(run_with_natives(text, {.steps = twice}).status == Progress::kDone);
    CHECK(run_with_natives(text, {.steps = twice - 1}).status == Progress::kFailed);
  }
}

TEST_CASE("long native work sees that the program is to stop") {
  CHECK(run_with_natives("stop()\nwork(1000000)", {.steps = 1ULL << 40U}).status ==
        Progress::kCancelled);
}

TEST_CASE("memory that native functions hold counts against the limit, and is given back") {
  const RunLimits limits{.heap_bytes = 1 << 20};
  CHECK(run_with_natives("for (i in range(100)) hold(1000000)", limits).status == Progress::kDone);
  CHECK(run_with_natives("hold(1048577)", limits).status == Progress::kFailed);
}
