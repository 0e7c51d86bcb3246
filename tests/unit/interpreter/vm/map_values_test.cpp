// Functions of a host that take and give maps.

#include "armlet/interpreter/binding/map_values.hpp"

#include <doctest/doctest.h>

#include <string>

#include "armlet/interpreter/engine.hpp"

namespace armlet {
namespace {

// total(stock): the sum of all values.
Signal total(Vm&, Slot* args) {
  std::int64_t sum = 0;
  for (const MapEntry& entry : map_value(args[0]).all()) {
    if (!entry.is_removed) sum += entry.value.i;
  }
  return give(args, sum);
}

// at(lists, key): the list of a key, or an empty one.
Signal at(Vm& vm, Slot* args) {
  const Slot* found = nullptr;
  if (!find_in_map(vm, map_value(args[0]), args[1], found)) return Signal::kFail;
  if (found == nullptr) return give(args, new_list(vm, 0, false));
  retain(found->o);
  return give(args, found->o);
}

// squares(n): the squares of n, n - 1 ... 1, some of them stored twice.
Signal squares(Vm& vm, Slot* args) {
  const std::int64_t n = args[0].i;
  MapObj* map = new_map(vm, false, false);
  for (std::int64_t i = 2 * n; map != nullptr && i-- > 0;) {
    const std::int64_t key = i % n + 1;
    if (put_into_map(vm, *map, slot_of(key), slot_of(key * key))) continue;
    release(vm, map);
    map = nullptr;
  }
  return give(args, map);
}

// named(words): each text with its number as a text.
Signal named(Vm& vm, Slot* args) {
  const auto words = items_value(args[0]);
  MapObj* map = new_map(vm, true, true);
  for (std::size_t i = 0; map != nullptr && i < words.size(); ++i) {
    Obj* number = new_text(vm, std::to_string(i));
    if (number != nullptr && put_into_map(vm, *map, words[i], slot_of(number))) continue;
    release(vm, map);
    map = nullptr;
  }
  return give(args, map);
}

constexpr NativeFunction kFunctions[] = {
    {.name = "total", .signature = "(stock: int[string]) -> int", .thunk = total},
    {.name = "at", .signature = "(lists: double[][string], key: string) -> double[]", .thunk = at},
    {.name = "squares", .signature = "(n: int) -> int[int]", .thunk = squares},
    {.name = "named", .signature = "(words: string[]) -> string[string]", .thunk = named},
    {.name = "count",
     .signature = "(maps: int[string][], more: int[string]?) -> int",
     .thunk = [](Vm&, Slot* args) {
       const bool more = args[1].o != nullptr;
       return give(args, static_cast<std::int64_t>(items_value(args[0]).size()) + (more ? 1 : 0));
     }}};

std::string printed_by(const std::string& text, const RunLimits& limits = {}) {
  Engine engine;
  engine.add_functions(kFunctions);
  REQUIRE(engine.check_signatures().empty());
  const Compilation compilation = engine.compile(text, "maps.rbt");
  if (compilation.program == nullptr)
    return compilation.diagnostics[0].code + ' ' + compilation.diagnostics[0].message;
  std::string printed;
  VmOptions options;
  options.limits = limits;
  options.output = [&](std::string_view part) { printed += part; };
  Vm vm(compilation.program, std::move(options));
  const RunResult result = vm.run();
  return result.error ? result.error->code : printed;
}

TEST_CASE("a host takes maps") {
  CHECK(printed_by("print(total([\"bolt\": 3, \"nut\": 5]), total([:]))") == "8 0\n");
  CHECK(printed_by(
            "var m = [\"a\": 1, \"b\": 2, \"c\": 4]\nlet b = m.remove(\"b\")\nprint(total(m))") ==
        "5\n");
  CHECK(printed_by("let m = [\"a\": [1.0, 2.5]]\nprint(at(m, \"a\"), at(m, \"b\"))") ==
        "[1.0, 2.5] []\n");
  CHECK(printed_by("print(count([[\"a\": 1], [:]]), count([], [\"a\": 1]))") == "2 1\n");
}

TEST_CASE("a host gives maps") {
  CHECK(printed_by("print(squares(3))") == "[3: 9, 2: 4, 1: 1]\n");
  CHECK(printed_by("var s = squares(20)\ns[7] += 1\nprint(s.length, s[7], s == squares(20))") ==
        "20 50 false\n");
  CHECK(printed_by("print(named([\"a\", \"b\", \"a\"]))") == "[\"a\": \"2\", \"b\": \"1\"]\n");
}

TEST_CASE("maps of other keys or values are refused") {
  CHECK(printed_by("print(total([1: 2]))").substr(0, 5) == "E0313");
  CHECK(printed_by("print(total([\"a\": 0.5]))").substr(0, 5) == "E0303");
}

TEST_CASE("maps of a host count against the heap limit, and nothing leaks") {
  for (std::uint64_t bytes = 2000; bytes < 80'000; bytes += 3000) {
    const std::string out =
        printed_by("print(squares(500).length, named([\"a\", \"b\"]))", {.heap_bytes = bytes});
    CAPTURE(bytes);
    CHECK((out == "R0628" || out == "500 [\"a\": \"0\", \"b\": \"1\"]\n"));
  }
}

TEST_CASE("a signature with keys that no map has is named") {
  Engine engine;
  const NativeFunction wrong[] = {{.name = "f", .signature = "(m: int[double])", .thunk = total},
                                  {.name = "g", .signature = "(m: T[string])", .thunk = total},
                                  {.name = "h", .signature = "(m: int[string)", .thunk = total}};
  engine.add_functions(wrong);
  const std::vector<std::string> faults = engine.check_signatures();
  REQUIRE(faults.size() == 3);
  CHECK(faults[0].find("keys are texts or ints") != std::string::npos);
  CHECK(faults[1].find("no variable type") != std::string::npos);
}

}  // namespace
}  // namespace armlet
