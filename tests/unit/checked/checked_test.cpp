// What a build with ARMLET_CHECKED finds in functions of the host.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

#include "armlet/interpreter/engine.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/stdlib/session.hpp"
#include "library.hpp"

using namespace armlet;

namespace {

const HostType kApple{.name = "apple", .size = 8};
const HostType kPear{.name = "pear", .size = 8};

Signal leaves_nothing(Vm&, Slot*) { return Signal::kDone; }
Signal leaves_text(Vm& vm, Slot* args) { return give(args, new_text(vm, "text")); }
Signal leaves_double(Vm&, Slot* args) { return give(args, 1.5); }
Signal leaves_seven(Vm&, Slot* args) { return give(args, std::int64_t{7}); }
Signal leaves_null(Vm&, Slot* args) {
  args[0].o = nullptr;
  return Signal::kDone;
}
Signal leaves_second(Vm&, Slot* args) {
  args[0] = args[1];
  return Signal::kDone;
}
Signal leaves_references(Vm& vm, Slot* args) {
  ListObj* list = new_list(vm, 1, true);
  list->data[0].o = nullptr;
  return give(args, list);
}
Signal leaves_pear(Vm& vm, Slot* args) { return give(args, new_host_value(vm, kPear, 1.0)); }
Signal leaves_apple(Vm& vm, Slot* args) { return give(args, new_host_value(vm, kApple, 1.0)); }
Signal calls_with_number(Vm& vm, Slot* args) {
  const Slot wrong[] = {slot_of(1.5)};
  Slot result{.i = 0};
  return vm.call(args[0].o, wrong, result) ? give(args, result.i) : Signal::kFail;
}
Signal calls_with_list(Vm& vm, Slot* args) {
  Slot list = slot_of(static_cast<Obj*>(new_list(vm, 1, false)));
  Slot result{.i = 0};
  const bool done = vm.call(args[0].o, {&list, 1}, result);
  release(vm, list.o);
  return done ? give(args, result.i) : Signal::kFail;
}

constexpr NativeFunction kFunctions[] = {
    {.name = "noText", .signature = "() -> string", .thunk = leaves_nothing},
    {.name = "noInt", .signature = "() -> int", .thunk = leaves_nothing},
    {.name = "noReal", .signature = "() -> double", .thunk = leaves_nothing},
    {.name = "noIntOf", .signature = "(s: string) -> int", .thunk = leaves_nothing},
    {.name = "noTextOf", .signature = "(x: double) -> string", .thunk = leaves_nothing},
    {.name = "notRetained", .signature = "(s: string) -> string", .thunk = leaves_nothing},
    {.name = "second", .signature = "(n: int, s: string) -> string", .thunk = leaves_second},
    {.name = "textForList", .signature = "() -> double[]", .thunk = leaves_text},
    {.name = "doubleForText", .signature = "(n: int) -> string", .thunk = leaves_double},
    {.name = "doubleForBool", .signature = "() -> bool", .thunk = leaves_double},
    {.name = "sevenForBool", .signature = "() -> bool", .thunk = leaves_seven},
    {.name = "nullText", .signature = "() -> string", .thunk = leaves_null},
    {.name = "references", .signature = "() -> double[]", .thunk = leaves_references},
    {.name = "pear", .signature = "() -> apple", .thunk = leaves_pear},
    {.name = "apple", .signature = "() -> apple", .thunk = leaves_apple},
    {.name = "seven", .signature = "() -> int", .thunk = leaves_seven},
    {.name = "nothing", .signature = "()", .thunk = leaves_nothing},
    {.name = "withNumber",
     .signature = "(f: fn(string) -> int) -> int",
     .thunk = calls_with_number},
    {.name = "withList", .signature = "(f: fn(string) -> int) -> int", .thunk = calls_with_list},
};

std::string run(const std::string& text) {
  Engine engine;
  engine.add_functions(kFunctions).add_type(kApple).add_type(kPear);
  const Compilation compilation = engine.compile(text, "checked.rbt");
  REQUIRE(compilation.program != nullptr);
  std::string printed;
  Vm vm(compilation.program, {.output = [&](std::string_view part) { printed += part; }});
  const RunResult result = vm.run();
  return printed + (result.error ? result.error->message : std::string());
}

std::string said(const std::string& call) {
  return run(
      "var s = \"long enough to have an object of its own\"\nvar n = 3\nvar x = 1.5\n"
      "try { let r = " +
      call + "; print(s, n, x) } catch (e) { print(e.kind, e.message) }\n");
}

}  // namespace

TEST_CASE("results that were not left, or are not what was declared, are failures of kind Host") {
  const std::string unset = " of the host left no result: what was there before is still there\n";
  CHECK(said("noText()") == "Host `noText`" + unset);
  CHECK(said("noInt()") == "Host `noInt`" + unset);
  CHECK(said("noReal()") == "Host `noReal`" + unset);
  CHECK(said("noIntOf(s)") == "Host `noIntOf`" + unset);
  CHECK(said("noTextOf(x)") == "Host `noTextOf`" + unset);
  CHECK(said("textForList()") ==
        "Host `textForList` of the host left a text where a list is expected\n");
  CHECK(said("doubleForText(n)") ==
        "Host `doubleForText` of the host left no object where a string is expected\n");
  CHECK(said("doubleForBool()") ==
        "Host `doubleForBool` of the host left a bool that is neither true nor false\n");
  CHECK(said("sevenForBool()") ==
        "Host `sevenForBool` of the host left a bool that is neither true nor false\n");
  CHECK(said("nullText()") ==
        "Host `nullText` of the host left nothing where a string is expected\n");
  CHECK(
      said("references()") ==
      "Host `references` of the host left a list of references where one of numbers is expected\n");
  CHECK(said("pear()") == "Host `pear` of the host left a pear where a apple is expected\n");
}

TEST_CASE("an argument that is left as the result needs a count of its own") {
  CHECK(said("notRetained(s + \"!\")") ==
        "Host `notRetained` of the host left an argument that it has not retained\n");
  CHECK(said("second(n, s + \"!\")") ==
        "Host `second` of the host left an argument that it has not retained\n");
}

TEST_CASE("results that are well pass") {
  CHECK(run("print(seven())\nnothing()\nlet a = apple()\nprint(\"on\")") == "7\non\n");
}

TEST_CASE("arguments of calls by the host are what the function declares") {
  const std::string f = "fn f(s: string) -> int { return s.length }\n";
  CHECK(run(f + "print(withNumber(f))") ==
        "`withNumber` failed: Argument 1 of a call by the host is no object where a string is "
        "expected.");
  CHECK(run(f + "try { print(withList(f)) } catch (e) { print(e.kind) }") == "Host\n");
}

TEST_CASE("the library keeps to what it declares, in every script and example") {
  int ran = 0;
  for (const char* folder : {"tests/scripts", "examples"}) {
    const auto root = std::filesystem::path(ARMLET_ROOT) / folder;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
      if (entry.path().extension() != ".rbt") continue;
      std::ifstream file(entry.path());
      SessionOptions options = at_the_table();
      options.limits.steps = 20'000;
      Session session(library_engine(), std::move(options));
      if (!session.compile(std::string(std::istreambuf_iterator<char>(file), {}), "p.rbt"))
        continue;
      const RunResult result = session.run();
      ++ran;
      INFO(entry.path().string());
      const std::string message = result.error ? result.error->message : std::string();
      CAPTURE(message);
      CHECK(message.find("of the host left") == std::string::npos);
      CHECK(message.find("of a call by the host") == std::string::npos);
    }
  }
  CHECK(ran > 50);
}
