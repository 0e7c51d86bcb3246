#include <doctest/doctest.h>

#include <map>
#include <string>

#include "script_support.hpp"

using namespace armlet;
using lang::script_engine;

namespace {

using Files = std::map<std::string, std::string>;

// Compiles "main.rbt" of a host that has the given files, and counts what is asked for.
Compilation compile(const Files& files, int* asked = nullptr) {
  CompileOptions options;
  options.load = [&files, asked](const std::string& path, const std::string&) {
    if (asked != nullptr) ++*asked;
    ImportedText out;
    const auto found = files.find(path);
    if (found != files.end()) {
      out.name = path;
      out.text = found->second;
    }
    for (const auto& [name, text] : files) out.others.push_back(name);
    return out;
  };
  return script_engine().compile(files.at("main.rbt"), "main.rbt", options);
}

std::string run(const Compilation& compilation) {
  std::string out;
  for (const Diagnostic& message : compilation.diagnostics) out += message.code + ' ';
  if (compilation.program == nullptr) return out;
  VmOptions options;
  options.output = [&](std::string_view text) { out += text; };
  Vm vm(compilation.program, std::move(options));
  const RunResult result = vm.run();
  return result.error ? out + result.error->code : out;
}

}  // namespace

TEST_CASE("without files from the host an import says so") {
  const Compilation result = script_engine().compile("import \"a.rbt\"\nprint(a.x)", "main.rbt");
  REQUIRE(result.diagnostics.size() == 1);
  CHECK(result.diagnostics[0].code == "E0213");
  CHECK(result.diagnostics[0].why == "the host of this program gives it no files to import");
}

TEST_CASE("a file is one source however often it is imported, and gets its values once") {
  const Files files = {{"main.rbt", "import \"a.rbt\"\nimport \"b.rbt\"\nprint(a.n, b.n)"},
                       {"a.rbt", "import \"c.rbt\"\nlet n = c.next()"},
                       {"b.rbt", "import \"c.rbt\" as d\nlet n = d.next()"},
                       {"c.rbt", "var count = 0\nfn next() -> int { count++\nreturn count }"}};
  const Compilation result = compile(files);
  CHECK(result.sources->size() == 4);
  CHECK((*result.sources)[0].name() == "main.rbt");
  CHECK(run(result) == "1 2\n");
}

TEST_CASE("programs share nothing with each other through their imports") {
  const Files files = {{"main.rbt", "import \"a.rbt\"\nprint(a.next())"},
                       {"a.rbt", "var count = 0\nfn next() -> int { count++\nreturn count }"}};
  const Compilation result = compile(files);
  CHECK(run(result) == "1\n");
  CHECK(run(result) == "1\n");
}

TEST_CASE("defaults and generic functions are read where they are declared") {
  const Files files = {
      {"main.rbt", "import \"a.rbt\"\nlet base = 7\nprint(a.f(), a.g(2), a.P().x)"},
      {"a.rbt",
       "let k = 3\nfn f(x: int = 4) => x + k\nfn g(x) => h(x) + f(x: 1)\nfn h(x) => x * k\n"
       "struct P { x: int = 5 }"}};
  CHECK(run(compile(files)) == "7 10 5\n");
}

TEST_CASE("the robot of a program and the names of its files do not mix") {
  const Files files = {{"main.rbt", "import \"a.rbt\"\nlet x = 1\nfn f() => 2\nprint(x, f(), a.x)"},
                       {"a.rbt", "let x = f()\nfn f() => 20\nfn g() => y"}};
  CHECK(run(compile(files)) == "E0201 ");
}

TEST_CASE("a name that a file with mistakes may have declared is not reported") {
  const Files files = {{"main.rbt", "import \"a.rbt\"\nprint(a.x, a.y)\nlet z: a.T = a.x"},
                       {"a.rbt", "let x = \nlet q = 3"}};
  const Compilation result = compile(files);
  REQUIRE(result.diagnostics.size() == 1);
  CHECK(result.diagnostics[0].mark.span.source == 1);
}

TEST_CASE("an import that failed is reported once") {
  const Files files = {{"main.rbt",
                        "import \"aa.rbt\"\nprint(aa.x, aa.f(2))\nlet z: aa.T = aa.x\n"
                        "aa.T w { n: 2 }\nprint(z.n + w.n)"},
                       {"ab.rbt", "let x = 1"}};
  const Compilation result = compile(files);
  REQUIRE(result.diagnostics.size() == 1);
  CHECK(result.diagnostics[0].code == "E0213");
  REQUIRE(result.diagnostics[0].fix);
  CHECK(result.diagnostics[0].fix->edits[0].text == "\"ab.rbt\"");
}

TEST_CASE("circles of any length end with their files named") {
  for (int n = 1; n <= 5; ++n) {
    Files files;
    const auto name = [n](int i) {
      return i % n == 0 ? std::string("main.rbt") : "m" + std::to_string(i % n) + ".rbt";
    };
    for (int i = 0; i < n; ++i) files[name(i)] = "import \"" + name(i + 1) + "\" as next";
    const Compilation result = compile(files);
    REQUIRE(result.diagnostics.size() == 1);
    CHECK(result.diagnostics[0].code == "E0214");
    const std::string& message = result.diagnostics[0].message;
    for (int i = 0; i < n; ++i) CHECK(message.find(name(i)) != std::string::npos);
  }
}

TEST_CASE("chains of imports end at a limit") {
  CompileOptions options;
  int asked = 0;
  options.load = [&asked](const std::string&, const std::string&) {
    const std::string number = std::to_string(++asked);
    return ImportedText{.name = number, .text = "import \"x" + number + ".rbt\""};
  };
  const Compilation result = script_engine().compile("import \"x.rbt\"", "main.rbt", options);
  REQUIRE(result.diagnostics.size() == 1);
  CHECK(result.diagnostics[0].code == "E0124");
  CHECK(asked == 200);
}

TEST_CASE("the texts of all files together have the limit of one") {
  const Files files = {{"main.rbt", "import \"a.rbt\"\nprint(1)"},
                       {"a.rbt", "let s = \"" + std::string(300, 'x') + "\""}};
  CompileOptions options;
  options.limits.bytes = 200;
  options.load = [&](const std::string& path, const std::string&) {
    return ImportedText{.name = path, .text = files.at(path)};
  };
  const Compilation result = script_engine().compile(files.at("main.rbt"), "main.rbt", options);
  REQUIRE(result.diagnostics.size() == 1);
  CHECK(result.diagnostics[0].code == "E0124");
}

TEST_CASE("a message about an imported file shows its name and its text") {
  const Files files = {{"main.rbt", "import \"a.rbt\"\nprint(a.f(0))"},
                       {"a.rbt", "\n\nfn f(x: int) => 1 / x"}};
  const Compilation result = compile(files);
  REQUIRE(result.program != nullptr);
  Vm vm(result.program, {});
  const RunResult ran = vm.run();
  REQUIRE(ran.error);
  CHECK(ran.error->code == "R0611");
  CHECK(result.sources->operator[](ran.error->mark.span.source).name() == "a.rbt");
  REQUIRE(ran.error->when);
  CHECK(ran.error->when->calls == std::vector<std::string>{"f, called on line 2 of main.rbt"});
}

TEST_CASE("advice and tests of imported files stay with them") {
  const Files files = {{"main.rbt", "import \"a.rbt\"\ntest \"mine\" { assert(a.x == 1) }"},
                       {"a.rbt", "let x = 1\ntest \"theirs\" { assert(false) }"}};
  const Compilation result = compile(files);
  REQUIRE(result.program != nullptr);
  CHECK(result.program->test_names() == std::vector<std::string>{"mine"});
}
