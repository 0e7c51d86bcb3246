#include "armlet/interpreter/engine.hpp"

#include <doctest/doctest.h>

#include <string>

#include "script_support.hpp"

using namespace armlet;
using lang::compile_script;
using lang::script_engine;

namespace {

// The output of one test of a program, or the code of what went wrong.
std::string run_test(const Compilation& compilation, std::size_t index) {
  std::string out;
  VmOptions options;
  options.output = [&](std::string_view text) { out += text; };
  Vm vm(compilation.program, std::move(options));
  const RunResult result = vm.run_test(index);
  return result.error.has_value() ? out + result.error->code : out;
}

}  // namespace

TEST_CASE("a text becomes a program that several machines can run") {
  const Compilation compilation =
      script_engine().compile("var n = 1\nn += 1\nprint(n)", "count.rbt");
  REQUIRE(compilation.program != nullptr);
  CHECK(compilation.diagnostics.empty());
  CHECK(compilation.program->sources()[0].name() == "count.rbt");
  for (int run = 0; run < 2; ++run) {
    std::string out;
    VmOptions options;
    options.output = [&](std::string_view text) { out += text; };
    Vm vm(compilation.program, std::move(options));
    CHECK(vm.run().status == Progress::kDone);
    CHECK(out == "2\n");
  }
}

TEST_CASE("mistakes come back as messages, and no program") {
  const Compilation compilation = compile_script("print(unknown)\nlet x: int = \"a\"\n");
  CHECK(compilation.program == nullptr);
  REQUIRE(compilation.diagnostics.size() == 2);
  CHECK(compilation.diagnostics[0].code == "E0201");
  CHECK(compilation.sources->size() == 1);
}

TEST_CASE("nothing that a text does makes the compiler throw") {
  const std::string texts[] = {"",        "\xFF\xFE",    "(((((",
                               "fn f( {", "let let let", std::string(100'000, '(')};
  for (const std::string& text : texts) {
    CHECK_NOTHROW((void)compile_script(text));
  }
}

TEST_CASE("a program knows its tests and the library functions it mentions") {
  const Compilation compilation =
      compile_script("print(sqrt(2.0))\ntest \"one\" { assert(true) }\ntest \"two\" { }");
  REQUIRE(compilation.program != nullptr);
  CHECK(compilation.program->test_names() == std::vector<std::string>{"one", "two"});
  CHECK(compilation.program->mentions("sqrt"));
  CHECK_FALSE(compilation.program->mentions("hypot"));
  CHECK(compilation.program->disassemble().find("HALT") != std::string::npos);
}

TEST_CASE("a test runs after the declarations alone") {
  const Compilation compilation = compile_script(
      "var n = 40\nlet two = 2\nprint(\"not in tests\")\nn = 0\n"
      "test \"sum\" { print(n + two)\n assert(n + two == 42) }\ntest \"false\" { assert(n == two) "
      "}");
  REQUIRE(compilation.program != nullptr);
  CHECK(run_test(compilation, 0) == "42\n");
  CHECK(run_test(compilation, 1) == "R0608");
}

TEST_CASE("every declared signature can be read, and one that cannot is named") {
  CHECK(script_engine().check_signatures().empty());
  static const NativeFunction broken[] = {{.name = "broken",
                                           .signature = "(x: nonsense) -> int",
                                           .help = "Cannot be read.",
                                           .example = "broken(1)"}};
  Engine engine;
  engine.add_functions(broken);
  const std::vector<std::string> faults = engine.check_signatures();
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].find("broken") != std::string::npos);
}
