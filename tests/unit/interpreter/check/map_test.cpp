// Maps in the heap: no leaks, and keys that someone has chosen badly on purpose.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "refused_memory.hpp"
#include "script_support.hpp"
#include "vm/state/state.hpp"

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

// As the map mixes them (vm/values/map.cpp).
std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ bits >> 30U) * 0xBF58'476D'1CE4'E5B9ULL;
  bits = (bits ^ bits >> 27U) * 0x94D0'49BB'1331'11EBULL;
  return bits ^ bits >> 31U;
}

constexpr int kKeys = 2000;

// Keys that begin at one index for so many and go on by the same steps.
std::vector<std::int64_t> keys_that_meet() {
  std::vector<std::int64_t> keys;
  constexpr std::uint64_t kBitsOfStep = 0x1FFE'0000U;  // but for its last one
  for (std::uint64_t i = 1; keys.size() < kKeys; ++i) {
    if ((mixed(i << 32U) & kBitsOfStep) == 0) keys.push_back(static_cast<std::int64_t>(i << 32U));
  }
  return keys;
}

// Stores under all keys.
std::uint64_t steps_with_keys(const std::vector<std::int64_t>& keys) {
  std::string list;
  for (const std::int64_t key : keys) list += (list.empty() ? "" : ", ") + std::to_string(key);
  const auto program =
      compile_script("var m: int[int] = [:]\nfor (k in [" + list + "]) m[k] = 1\nprint(m.length)")
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

TEST_CASE("keys that meet in the index are paid for in steps, those that people take are not") {
  const auto keys_of = [](auto key) {
    std::vector<std::int64_t> keys;
    for (std::int64_t i = 0; i < kKeys; ++i) keys.push_back(key(i));
    return keys;
  };
  const std::uint64_t usual = steps_with_keys(keys_of([](std::int64_t i) { return i; }));
  CHECK(usual < 2200);
  CHECK(steps_with_keys(keys_that_meet()) > 5 * usual);
  for (const std::int64_t stride :
       {std::int64_t{-1}, std::int64_t{1000}, std::int64_t{1} << 12U, std::int64_t{1} << 16U,
        std::int64_t{1} << 20U, std::int64_t{1} << 32U, std::int64_t{1} << 48U}) {
    CAPTURE(stride);
    CHECK(steps_with_keys(keys_of([&](std::int64_t i) { return i * stride; })) == usual);
  }
  // Positions of a plane, packed into one number.
  CHECK(steps_with_keys(keys_of([](std::int64_t i) { return (i / 40) << 32U | (i % 40); })) ==
        usual);
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
