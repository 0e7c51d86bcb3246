// Maps in the heap: no leaks, and keys that someone has chosen badly on purpose.

#include <doctest/doctest.h>

#include <string>

#include "refused_memory.hpp"
#include "script_support.hpp"
#include "vm/state.hpp"

using namespace armlet;
using namespace armlet::lang;

namespace {

constexpr const char* kProgram = R"(
struct Bin { count: int[string] = [:] }
var m: string[int] = [:]
for (i in range(40)) m[i] = f"number {i}"
for (i in range(30)) m.remove(i)
let copy = m
m[100] = copy[35] + "!"
var nested = ["a": ["x": [1.0]], "b": [:]]
nested["b"]["y"] = [2.0, 3.0]
nested["a"]["x"].push(4)
var bin = Bin()
bin.count["bolt"] = 3
bin.count["bolt"] += nested.length
for (k, v in copy) m[k + 1000] = v
print(m == copy, m.keys().length, nested, bin, m.get(5, "none"), copy.values()[0], m.length)
)";

// The number of which the mixing of vm/heap/map.cpp makes `hash`.
std::uint64_t with_hash(std::uint64_t hash) {
  const auto undo_shift = [](std::uint64_t x, unsigned by) {
    std::uint64_t out = x;
    for (unsigned done = by; done < 64; done += by) out = x ^ out >> by;
    return out;
  };
  const auto inverse = [](std::uint64_t odd) {
    std::uint64_t out = odd;
    for (int i = 0; i < 6; ++i) out *= 2 - odd * out;
    return out;
  };
  hash = undo_shift(hash, 31) * inverse(0x94D0'49BB'1331'11EBULL);
  hash = undo_shift(hash, 27) * inverse(0xBF58'476D'1CE4'E5B9ULL);
  return undo_shift(hash, 30);
}

// Stores under 2000 keys.
std::uint64_t steps_with_keys(bool same_hash) {
  std::string keys;
  for (std::uint64_t i = 1; i <= 2000; ++i) {
    const auto key = static_cast<std::int64_t>(same_hash ? with_hash(i << 32U) : i);
    keys += (keys.empty() ? "" : ", ") + std::to_string(key);
  }
  const auto program =
      compile_script("var m: int[int] = [:]\nfor (k in [" + keys + "]) m[k] = 1\nprint(m.length)")
          .program;
  REQUIRE(program != nullptr);
  const ScriptRun run = run_compiled(program, {});
  CHECK(run.printed == "2000\n");
  return run.result.steps;
}

}  // namespace

TEST_CASE("maps have the same values with and without optimisation") {
  const ScriptRun fast = run_compiled(compile_script(kProgram, true).program, {});
  const ScriptRun plain = run_compiled(compile_script(kProgram, false).program, {});
  CHECK(fast.result.status == Progress::kDone);
  CHECK(fast.printed == plain.printed);
  CHECK(
      fast.printed ==
      "false 21 [\"a\": [\"x\": [1.0, 4.0]], \"b\": [\"y\": [2.0, 3.0]]] Bin(count: [\"bolt\": 5]) "
      "none number 30 21\n");
}

TEST_CASE("any allocation of a map may fail without a leak") {
  const std::uint64_t failed = runs_failed_for_memory(kProgram, 300);
  CHECK(failed > 100);
  CHECK(failed < 299);
}

TEST_CASE("keys with the same hash are paid for in steps") {
  const std::uint64_t usual = steps_with_keys(false);
  CHECK(usual < 2200);
  CHECK(steps_with_keys(true) > 5 * usual);
}

TEST_CASE("a map is released without recursion, however deep it is") {
  const auto program = compile_script(R"(
struct Node { next: Node[string] = [:] }
var list = Node()
for (i in range(100000)) list = Node(next: ["more": list])
print(list.next.length)
)")
                           .program;
  REQUIRE(program != nullptr);
  CHECK(run_compiled(program, {}).printed == "1\n");
}
