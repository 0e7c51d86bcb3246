// Parts of calls that messages mark, named by their parameters.

#include "armlet/interpreter/call_part.hpp"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/answer.hpp"
#include "armlet/interpreter/define.hpp"
#include "armlet/interpreter/engine.hpp"
#include "vocabulary/parameter_index.hpp"

namespace armlet {
namespace {

Answer<double> drive(Vm& vm, double distance, std::optional<double> speed) {
  if (speed && *speed < 0.0)
    return fail(vm, {.headline = Headline::own("R0609", "too slow"),
                     .mark = at("speed"),
                     .fix = "use abs({arg})"});
  if (distance < 0.0)
    return fail(vm, {.headline = Headline::own("R0609", "backwards"), .mark = CallPart::first()});
  if (distance > 9.0)
    return fail(vm, {.headline = Headline::own("R0609", "too far"), .mark = at("sped")});
  return distance;
}

void check_drive(CheckCall& call) {
  if (!call.given(at("speed"))) return;
  const auto speed = call.constant(at("speed"));
  if (speed && speed->real > 5.0)
    call.report(make_diagnostic("E0513", call.span(at("speed")), {"the speed", "at most 5", "6"}));
}
void check_unknown(CheckCall& call) { (void)call.given(at("sped")); }

constexpr NativeFunction kFunctions[] = {
    def<drive>("drive(distance: double, speed: double?) -> double", "", "", {.check = check_drive}),
    def<drive>("unknown(distance: double, speed: double?) -> double", "", "",
               {.check = check_unknown}),
};

Engine engine_of_tests() {
  Engine engine;
  engine.add_functions(kFunctions);
  return engine;
}

Diagnostic failure_of(const std::string& text) {
  const Compilation compilation = engine_of_tests().compile(text, "test.rbt");
  REQUIRE(compilation.program != nullptr);
  Vm vm(compilation.program, {});
  const RunResult result = vm.run();
  REQUIRE(result.error.has_value());
  return *result.error;
}
std::string marked(const Diagnostic& d, const std::string& text) {
  return text.substr(d.mark.span.begin, d.mark.span.end - d.mark.span.begin);
}

TEST_CASE("a failure marks the argument of the parameter that it names") {
  for (const std::string call : {"drive(1.0, -2.0)", "drive(1.0, speed: -2.0)"}) {
    const std::string text = "print(" + call + ")";
    const Diagnostic d = failure_of(text);
    CHECK(marked(d, text).ends_with("-2.0"));
    REQUIRE(d.fix.has_value());
    CHECK(d.fix->text == "use abs(-2.0)");
  }
  const std::string text = "print(drive(-3.0))";
  CHECK(marked(failure_of(text), text) == "-3.0");
}

TEST_CASE("a failure that names no parameter of its function says so") {
  const std::string text = "print(drive(10.0))";
  const Diagnostic d = failure_of(text);
  CHECK(marked(d, text) == "drive(10.0)");
  CHECK(d.message == "too far");
  CHECK(d.why.find("`sped`") != std::string::npos);
  CHECK(d.why.find("no such parameter") != std::string::npos);
}

TEST_CASE("a rule reads arguments by their names, and a name without parameter is refused") {
  const Engine engine = engine_of_tests();
  const std::string text = "print(drive(1.0, speed: 6.0))";
  const Compilation compilation = engine.compile(text, "test.rbt");
  REQUIRE(compilation.diagnostics.size() == 1);
  CHECK(marked(compilation.diagnostics[0], text) == "6.0");
  CHECK(engine.compile("print(drive(1.0, speed: 4.0))", "test.rbt").diagnostics.empty());
  const Compilation none = engine.compile("print(unknown(1.0))", "test.rbt");
  CHECK(none.program == nullptr);
  REQUIRE(none.diagnostics.size() == 1);
  CHECK(none.diagnostics[0].code == "E0198");  // a mistake of the library
  CHECK(none.diagnostics[0].why.find("has no parameter `sped`") != std::string::npos);
}

TEST_CASE("parameters are found in the text of a signature") {
  constexpr std::string_view kText =
      "(f: fn(time, S) -> U, y0: S, when: OdeEvent<S>{g: fn(time, S) -> double, stop: bool}[]?, "
      "word: string = \"a, b: c\", last: int[string]) -> Pair{first: T, second: U}";
  CHECK(lang::parameter_index(kText, "f") == 0);
  CHECK(lang::parameter_index(kText, "y0") == 1);
  CHECK(lang::parameter_index(kText, "when") == 2);
  CHECK(lang::parameter_index(kText, "word") == 3);
  CHECK(lang::parameter_index(kText, "last") == 4);
  for (const std::string_view name : {"g", "stop", "b", "first", "second", "", "y"})
    CHECK(lang::parameter_index(kText, name) == -1);
  CHECK(lang::parameter_index("()", "x") == -1);
}

TEST_CASE("parts of calls are equal if they mark the same") {
  CHECK(at("speed") == CallPart::parameter("speed"));
  CHECK_FALSE(at("speed") == at("time"));
  CHECK_FALSE(CallPart::first() == CallPart());
  CHECK(CallPart::operand(0) == CallPart::first());
  CHECK(CallPart::callee().is_callee());
  CHECK(at("speed").operand() == -1);
  CHECK(CallPart().operand() == -1);
  CHECK(kPart<"speed"> == at("speed"));
}

}  // namespace
}  // namespace armlet
