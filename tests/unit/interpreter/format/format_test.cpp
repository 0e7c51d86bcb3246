#include "armlet/interpreter/format.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "armlet/interpreter/render.hpp"
#include "format/lay_out.hpp"
#include "random/program.hpp"
#include "syntax/parse.hpp"
#include "syntax_dump.hpp"
#include "syntax_sentences.hpp"

namespace armlet::lang {
namespace {

// The text in the one layout; its messages if it cannot be read.
std::string formatted(const std::string& text) {
  SourceSet sources;
  const Formatted result = format_program(sources.add("test.rbt", text));
  std::string messages;
  for (const Diagnostic& problem : result.problems) messages += render_text(problem, sources);
  CHECK_FALSE(result.changed_meaning);
  return result.text.value_or(messages);
}

struct Read {
  explicit Read(const std::string& text) : source("test.rbt", text) {
    const Parsed parsed = parse(source, arena, sink, {.errors = 1000}, &shape);
    ok = parsed.ok;
    if (ok) tree = dump(parsed);
  }
  Source source;
  Arena arena;
  DiagnosticSink sink{1000};
  Shape shape;
  bool ok = false;
  std::string tree;
};

// Laid out twice, `text` means the same, has its comments, and stays as it is from then on.
void check_laws(const std::string& text) {
  const Read before(text);
  const std::string once = lay_out(before.source, before.shape);
  INFO("before:\n", text);
  INFO("after:\n", once);
  const Read after(once);
  REQUIRE(after.ok == before.ok);
  REQUIRE(after.tree == before.tree);
  REQUIRE(same_shape(before.shape, before.source, after.shape, after.source));
  REQUIRE(same_comments(before.shape, before.source, after.shape, after.source));
  REQUIRE(lay_out(after.source, after.shape) == once);
}

// The laws for a text that was made ugly, which must not have changed what it says.
void check_rough(const std::string& text, unsigned seed) {
  const std::string rough = roughened(text, seed);
  const Read plain(text);
  const Read ugly(rough);
  INFO(rough);
  REQUIRE(same_shape(plain.shape, plain.source, ugly.shape, ugly.source));
  check_laws(rough);
}

std::vector<std::string> all_programs() {
  std::vector<std::string> out;
  for (const char* folder : {"/examples", "/tests", "/bench", "/stdlib"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::string(ARMLET_ROOT) + folder)) {
      if (entry.path().extension() != ".rbt") continue;
      std::ifstream file(entry.path(), std::ios::binary);
      std::ostringstream text;
      text << file.rdbuf();
      out.push_back(text.str());
    }
  }
  return out;
}

TEST_CASE("every program of this repository means the same when it is laid out") {
  int laid_out = 0;
  unsigned seed = 0;
  for (const std::string& text : all_programs()) {
    if (!Read(text).ok) continue;
    ++laid_out;
    check_laws(text);
    for (int i = 0; i < 5; ++i) check_rough(text, ++seed);
  }
  CHECK(laid_out > 150);
}

TEST_CASE("random programs mean the same when they are laid out") {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const std::string text = oracle::RandomProgram(seed).text();
    check_laws(text);
    check_rough(text, seed);
  }
}

TEST_CASE("random sentences of the grammar mean the same when they are laid out") {
  SentenceWriter writer(11);
  for (unsigned seed = 0; seed < 2000; ++seed) {
    const std::string text = writer.text(writer.program());
    check_laws(text);
    check_rough(text, seed);
  }
}

TEST_CASE("a statement has a line, operators have blanks, blocks are indented") {
  CHECK(formatted("let a=1+2*-b;print(a)\nif(a>2){b();c( )}\nelse{d()}") ==
        "let a = 1 + 2 * -b;\nprint(a)\nif (a > 2) {\n    b();\n    c()\n} else {\n    d()\n}\n");
  CHECK(formatted("fn f( x:length )->area{return x*x}\nfn g(x)=>x ^ 2+(x+1)^2\n") ==
        "fn f(x: length) -> area { return x * x }\nfn g(x) => x^2 + (x + 1) ^ 2\n");
  CHECK(formatted("for(int i=0;i<3;i ++)\n{\n  p[i : 2] = ( int )x;\n}") ==
        "for (int i = 0; i < 3; i++) {\n    p[i:2] = (int) x;\n}\n");
  CHECK(formatted("let k : force / length = 800N/m\nlet r = a ? b:c\nlet n = - -a\n") ==
        "let k: force/length = 800N/m\nlet r = a ? b : c\nlet n = - -a\n");
  CHECK(formatted("let area = 2m ^ 2 * 3 .abs()") == "let area = 2m ^ 2 * 3 .abs()\n");
}

TEST_CASE("what was on one line stays on one line while it fits") {
  const std::string object = "object cube { shape: box(40mm, 40mm, 40mm); mass: 200g }\n";
  CHECK(formatted(object) == object);
  const std::string guard = "if (d > 45mm) grasp(cube); else { release(); }\n";
  CHECK(formatted(guard) == guard);
  const std::string below = "if (d > 45mm)\n    grasp(cube);\nelse\n    release();\n";
  CHECK(formatted(below) == below);
  CHECK(formatted("switch (a) { case 1: b() }") == "switch (a) { case 1: b() }\n");
  const std::string name(60, 'n');
  CHECK(formatted("when (a) { " + name + "(); " + name + "() }") ==
        "when (a) {\n    " + name + "();\n    " + name + "()\n}\n");
}

TEST_CASE("a comment behind a brace does not become documentation") {
  const std::string text = "test \"a\" // b\n{ /// c\n    robot arm = robots.scara()\n}\n";
  check_laws(text);
}

TEST_CASE("long lines are broken after an opening bracket or before an operator") {
  const std::string name(40, 'n');
  CHECK(formatted("f(" + name + ", " + name + ", g(1, 2), time: 2s)") ==
        "f(\n    " + name + ",\n    " + name + ",\n    g(1, 2),\n    time: 2s\n)\n");
  CHECK(formatted("let a = " + name + " + " + name + " * 2 + " + name) ==
        "let a = " + name + "\n    + " + name + " * 2\n    + " + name + "\n");
  CHECK(formatted("if (" + name + " && " + name + " && " + name + ") { a() }") ==
        "if (" + name + "\n        && " + name + "\n        && " + name + ") { a() }\n");
  std::string numbers = "double[] q = {0.25";
  for (int i = 0; i < 20; ++i) numbers += ", -0.25";
  const std::string filled = formatted(numbers + "};");
  CHECK(filled.substr(0, 30) == "double[] q = {\n    0.25, -0.25");
  CHECK(std::ranges::count(filled, '\n') == 4);
  CHECK(formatted("let A = [1, 2;\n 3, 4]") == "let A = [\n    1, 2;\n    3, 4\n]\n");
  CHECK(formatted("assertThrows(fn() {\nf()\n}, kind: \"a\")") ==
        "assertThrows(fn() {\n    f()\n}, kind: \"a\")\n");
}

TEST_CASE("comments stay where they belong") {
  CHECK(
      formatted("#!/usr/bin/armlet\n// a\n\n\n\nf() // b\n/// c\nlet x = 1 /* d */ + 2\n/* e */") ==
      "#!/usr/bin/armlet\n// a\n\nf()  // b\n/// c\nlet x = 1 /* d */ + 2\n/* e */\n");
  CHECK(formatted("if (a) // why\n{\n  // what\n\n  b()\n  // end\n}\n// else\nelse { c() }") ==
        "if (a) {  // why\n    // what\n\n    b()\n    // end\n}\n// else\nelse {\n    c()\n}\n");
  CHECK(formatted("f(a, // first\n b // second\n)") ==
        "f(\n    a,  // first\n    b  // second\n)\n");
}

TEST_CASE("columns that the author aligned stay aligned") {
  const std::string columns =
      "double[] home  = {0.0};     // rest\ndouble[] above = {0.61};    // ready\ndouble t = "
      "2.0;\n";
  CHECK(formatted(columns) == columns);
  CHECK(formatted("let a  = 1\nlet bbbb=2\n") == "let a = 1\nlet bbbb = 2\n");
  CHECK(formatted("let a   = 1 // x\nlet bb  = f( 2,3 ) // y\n") ==
        "let a  = 1  // x\nlet bb = f(2, 3)   // y\n");
}

TEST_CASE("byte-order marks and the line breaks of other systems stay") {
  CHECK(formatted("\xEF\xBB\xBF"
                  "let  a=1\r\n\r\n\r\nlet b=2") == "\xEF\xBB\xBFlet a = 1\r\n\r\nlet b = 2\r\n");
  check_laws(
      "\xEF\xBB\xBF"
      "f()      // a comment in a column");
  check_laws("\xEF\xBB\xBF\xEF\xBB\xBF\n// ");
  check_laws(
      "\xEF\xBB\xBF\xEF\xBB\xBF"
      "let a = 1  // two marks\nlet b = 2");
  CHECK(formatted("#!run\n;f()") == "#!run\n;\nf()\n");
  CHECK(formatted("// only a comment") == "// only a comment\n");
  CHECK(formatted("").empty());
  CHECK(formatted("\n\n").empty());
}

TEST_CASE("a program that cannot be read is refused with its messages") {
  CHECK(formatted("let = 3").find("E0") != std::string::npos);
  CHECK(formatted("f(1").find("E0") != std::string::npos);
}

}  // namespace
}  // namespace armlet::lang
