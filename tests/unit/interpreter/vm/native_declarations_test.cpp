// What rows of native functions declare beside types: units that follow from another parameter, and
// events of blocks.

#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/define.hpp"
#include "armlet/interpreter/engine.hpp"
#include "printed.hpp"

namespace armlet {
namespace {

std::string shown(std::span<const double>, std::optional<std::string_view> unit) {
  return unit ? "in <" + std::string(*unit) + ">" : "absent";
}

std::vector<std::string> happened;
template <BlockEvent kEvent>
void note() {
  happened.push_back(std::to_string(static_cast<int>(kEvent)));
}
void set_level(std::int64_t level) { happened.push_back("level " + std::to_string(level)); }

constexpr NativeFunction kDeclaredFunctions[] = {
    def<shown>("shown(x: D[], xUnit: unit(x)?) -> string", "", ""),
    def<shown>("named(values: D[], si: unit(values)?) -> string", "", ""),
    def<shown>("plain(x: D[], xUnit: string?) -> string", "", ""),
    def<note<BlockEvent::kWithBegins>>("with()", "", "", {.event = BlockEvent::kWithBegins}),
    def<note<BlockEvent::kWithEnds>>("with()", "", "", {.event = BlockEvent::kWithEnds}),
    def<set_level>("with.level(level: int)", "", ""),
};

std::string printed(const std::string& text) {
  Engine engine;
  engine.add_functions(kDeclaredFunctions);
  for (const std::string& fault : engine.check_signatures()) FAIL_CHECK(fault);
  return printed(engine, text);
}

TEST_CASE("a text that is declared as the unit of a parameter gets it from the type") {
  CHECK(printed("print(shown([1m, 2m]), shown([1.0]), shown([1m], xUnit: \"ft\"))") ==
        "in <m> in <> in <ft>\n");
  CHECK(printed("print(named([1s]))") == "in <s>\n");
}

TEST_CASE("the name of a parameter says nothing about its unit") {
  CHECK(printed("print(plain([1m]))") == "absent\n");
}

TEST_CASE("the unit of a parameter that does not exist is refused") {
  Engine engine;
  std::string why;
  try {
    engine.define(def(
        "wrong(x: double, u: unit(y)?) -> string",
        [](double, std::optional<std::string_view>) { return std::string(); }, "", ""));
  } catch (const ArgumentError& error) {
    why = error.what();
  }
  CHECK_MESSAGE(why.find("`u` is the unit of `y`, which is no parameter") != std::string::npos,
                why);
}

TEST_CASE("functions with an event run where the block begins and ends, and have no name") {
  happened.clear();
  CHECK(printed("with (level: 3) { print(\"inside\") }") == "inside\n");
  CHECK(happened == std::vector<std::string>{"1", "level 3", "2"});
  happened.clear();
  (void)printed("with (level: 3) { let xs = [1]; print(xs[3]) }");
  CHECK(happened == std::vector<std::string>{"1", "level 3", "2"});
  Engine engine;
  engine.add_functions(kDeclaredFunctions);
  CHECK(engine.compile("print(1); with()", "test.rbt").program == nullptr);
  CHECK_THROWS_AS(engine.add_functions(kDeclaredFunctions), ArgumentError);
}

}  // namespace
}  // namespace armlet
