// Rows of native functions with union types.

#include "vocabulary/union_rows.hpp"

#include <doctest/doctest.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/define.hpp"
#include "armlet/interpreter/engine.hpp"
#include "printed.hpp"

namespace armlet {
namespace {

std::string of_number(std::int64_t n, std::optional<double> k) {
  return "int " + std::to_string(n) + (k ? " k" : "");
}
std::string of_text(std::string_view text, std::optional<double>) {
  return "text " + std::string(text);
}
std::string of_list(std::span<const double> xs, std::optional<double>) {
  return "list of " + std::to_string(xs.size());
}
double same(double x) { return x; }
std::string pair_of(std::int64_t, std::string_view) { return "int, text"; }
std::string pair_of_texts(std::string_view, std::string_view) { return "text, text"; }
std::string pair_of_numbers(std::int64_t, std::int64_t) { return "int, int"; }
std::string pair_reversed(std::string_view, std::int64_t) { return "text, int"; }

constexpr NativeFunction kUnions[] = {
    def<of_number, of_text, of_list>("what(x: int | string | double[], k: double?) -> string",
                                     "What it is.", "what(1)"),
    def<same>("seconds(t: double | time) -> double", "A number.", "seconds(1s)"),
    def<pair_of_numbers, pair_of, pair_reversed, pair_of_texts>(
        "pair(a: int | string, b: int | string) -> string", "Two.", "pair(1, 2)"),
};

Engine engine_with_unions() {
  Engine engine;
  engine.add_functions(kUnions);
  CHECK(engine.check_signatures().empty());
  return engine;
}

std::string printed(const std::string& text) { return printed(engine_with_unions(), text); }

TEST_CASE("a row with unions stands for one signature for each choice of types") {
  using Texts = std::vector<std::string>;
  CHECK(lang::signatures_of("(x: int) -> int") == Texts{"(x: int) -> int"});
  CHECK(lang::signatures_of("(r: robot, frame: posC? | object, blend: length?) -> Move") ==
        Texts{"(r: robot, frame: posC?, blend: length?) -> Move",
              "(r: robot, frame: object, blend: length?) -> Move"});
  CHECK(lang::signatures_of("(a: fn(x, y) -> z | string = \"a | b, c\", n: int[] | int)") ==
        Texts{"(a: fn(x, y) -> z, n: int[])", "(a: fn(x, y) -> z, n: int)",
              "(a: string = \"a | b, c\", n: int[])", "(a: string = \"a | b, c\", n: int)"});
  CHECK(lang::has_union("(a: int | bool)"));
  CHECK_FALSE(lang::has_union("(a: int) -> bool"));
}

TEST_CASE("the types of a call choose the function of a row with unions") {
  CHECK(printed("print(what(1), what(\"a\"), what([1.0, 2.0]), what(x: 2, k: 0.5))") ==
        "int 1 text a list of 2 int 2 k\n");
  CHECK(printed("print(seconds(2s), seconds(3.0))") == "2.0 3.0\n");
  CHECK(
      printed("print(pair(1, 2)); print(pair(1, \"b\")); print(pair(\"a\", 2)); print(pair(\"a\", "
              "\"b\"))") == "int, int\nint, text\ntext, int\ntext, text\n");
}

TEST_CASE("a call that no choice takes is refused at its argument") {
  const Compilation compilation = engine_with_unions().compile("print(what(true))", "test.rbt");
  REQUIRE(compilation.diagnostics.size() == 1);
  CHECK(compilation.diagnostics[0].code == "E0313");
}

TEST_CASE("as many C++ functions as choices of types, or one") {
  Engine engine;
  constexpr NativeFunction kTwoOfThree[] = {
      def<of_number, of_text>("what(x: int | string | double[], k: double?) -> string", "", "")};
  engine.add_functions(kTwoOfThree);
  const std::vector<std::string> faults = engine.check_signatures();
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].find("3 choices of types, but there are 2 functions") != std::string::npos);
  const auto integer = [](std::int64_t n) { return n; };
  CHECK_THROWS_AS(engine.define(def("odd(x: int | string) -> int", integer, "", "")),
                  ArgumentError);
  engine.define(def("length(x: double | length) -> double", same, "", ""));
  CHECK(engine.compile("print(length(1mm))", "test.rbt").program != nullptr);
}

TEST_CASE("a row with unions cannot be added twice") {
  Engine engine = engine_with_unions();
  CHECK_THROWS_AS(engine.add_functions(kUnions), ArgumentError);
}

}  // namespace
}  // namespace armlet
