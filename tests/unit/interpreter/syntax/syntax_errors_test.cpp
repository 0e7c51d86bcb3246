#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "armlet/interpreter/render.hpp"
#include "syntax/parse.hpp"

namespace armlet::lang {
namespace {

std::vector<Diagnostic> messages_of(const Source& source) {
  Arena arena;
  DiagnosticSink sink;
  const Parsed parsed = parse(source, arena, sink);
  CHECK(parsed.ok != sink.has_errors());
  return sink.take_sorted();
}

// A message of the language reference: its text, and the program that it shows.
struct Sample {
  std::string message;
  std::string program;
};

Sample read_sample(const std::string& code) {
  static const std::regex kNumbered(R"( *(\d+) \| (.*))");
  std::ifstream file(std::filesystem::path(ARMLET_REFERENCE_DIR) / "messages" / (code + ".txt"));
  Sample out;
  int next = 1;
  std::smatch match;
  for (std::string line; std::getline(file, line);) {
    if (out.message.empty() && !line.starts_with("error")) continue;
    out.message += line + '\n';
    if (!std::regex_match(line, match, kNumbered)) continue;
    for (; next < std::stoi(match[1]); ++next) out.program += '\n';
    out.program += match[2];
  }
  out.program += '\n';
  return out;
}

TEST_CASE(
    "the messages of the language reference come word for word from the programs that they show") {
  for (const char* code : {"E0101", "E0102", "E0103", "E0110", "E0111", "E0112", "E0113", "E0114",
                           "E0115", "E0116", "E0117"}) {
    Sample sample = read_sample(code);
    if (std::string_view(code) == "E0116") sample.program += "}\n";
    SourceSet sources;
    std::string shown;
    for (const Diagnostic& message : messages_of(sources.add("cell.rbt", sample.program))) {
      shown += render_text(message, sources);
    }
    CHECK(shown == sample.message);
  }
}

// All messages of a text, each as: CODE `marked text` fix
std::string brief(const std::string& text) {
  const Source source("test.rbt", text);
  std::string out;
  for (const Diagnostic& message : messages_of(source)) {
    if (!out.empty()) out += "; ";
    out += message.code + " `" + std::string(source.slice(message.mark.span)) + '`';
    if (message.fix) out += ' ' + message.fix->text;
  }
  return out;
}

TEST_CASE("pieces that are no tokens are reported, one to a line") {
  CHECK(brief("let a = 'x\n") == "E0101 `'x` add a closing quote: let a = 'x'");
  CHECK(brief("let a = 1\nlet b = \"\"\"x\nlet c = 2x\n") ==
        "E0101 `\"\"\"` if it ends on this line, write \"\"\"x\"\"\"");
  CHECK(brief("let b = \"\"\"x\"\nprint(b)\n") ==
        "E0101 `\"\"\"` if it ends on this line, write \"\"\"x\"\"\"");
  CHECK(brief("let b = \"\"\"\nx\n") == "E0101 `\"\"\"` end it with \"\"\" behind its last line");
  CHECK(brief("let a = 2x") == "E0103 `2x` to multiply, write 2 * x");
  CHECK(brief("let a = 5MM") == "E0103 `5MM` did you mean 5mm?");
  CHECK(brief("insertObj(\u201Ccube\u201D)") == "E0104 `\u201Ccube\u201D` write \"cube\"");
  CHECK(brief("let a = b & c | d\nlet e = 3 @ 4\n") == "E0133 `&` write && for \"and\"; E0104 `@`");
  CHECK(brief("x()\n/* never\n closed\n") ==
        "E0106 `/*` end it with */, or write // for a comment that ends with its line");
}

TEST_CASE("texts say what is wrong inside them") {
  CHECK(brief("print(\"C:\\data\")") == "E0105 `\\d` for a backslash itself write two");
  CHECK(brief("print('\\u12')") == "E0105 `\\u12` for a backslash itself write two");
  CHECK(brief("print(f\"set {1, 2\")") == "E0107 `{`");
  CHECK(brief("print(f\"a } b\")") == "E0107 `}`");
  CHECK(brief("print(f\"{ }\")") == "E0107 `{ }`");
  CHECK(brief("print(f\"{x:5,d}\")") == "E0107 `5,d`");
  CHECK(brief("print(f\"{x + }\")") == "E0129 ``");
  CHECK(brief("print(f\"{x y}\")") == "E0128 `y`");
  CHECK(brief("print(f\"{(x}\")") == "E0110 `(` add `)` at the end of line 1");
}

TEST_CASE("numbers that do not fit are refused") {
  CHECK(brief("let a = 9223372036854775808") == "E0109 `9223372036854775808`");
  CHECK(brief("let a = 1e999; let b = 1e999mm") == "E0109 `1e999`; E0109 `1e999mm`");
}

TEST_CASE("a unit after a space takes its whole combination along") {
  CHECK(brief("moveL(p, speed: 3 mm/s)") == "E0102 `3 mm/s` write 3mm/s");
  CHECK(brief("let a = 2.5 deg") == "E0102 `2.5 deg` write 2.5deg");
}

TEST_CASE("a decimal comma becomes a point") {
  CHECK(brief("let a = 0,5") == "E0108 `0,5` write 0.5");
  CHECK(brief("double a = 0,5;") == "E0108 `0,5` write 0.5");
}

TEST_CASE("headers need their parentheses") {
  CHECK(brief("while i < 3 { i++ }") == "E0112 `i < 3` write while (i < 3) { ... }");
  CHECK(brief("if (a) && (b) { x() }") == "E0112 `(a) && (b)` write if ((a) && (b)) { ... }");
  CHECK(brief("for i in range(3) { x() }") ==
        "E0112 `i in range(3)` write for (i in range(3)) { ... }");
}

TEST_CASE("an unbraced body is one simple statement") {
  CHECK(brief("if (a) let x = 3") == "E0114 `let` put braces around the inner `let`");
  CHECK(brief("if (a) x() else for (i in z) y()") ==
        "E0114 `for (i in z)` put braces around the inner `for`");
}

TEST_CASE("steps are no values") {
  CHECK(brief("x = i++") == "E0115 `i++` use i here and write i++ on the next line");
  CHECK(brief("y = --i") == "E0115 `--i` write --i on the line before and use i here");
}

TEST_CASE("what surrounds a Java program is not needed") {
  CHECK(
      brief(
          "public class Foo {\n  public static void main(String[] a) {\n    print(1);\n  }\n}\n") ==
      "E0116 `public class Foo` delete this line and its closing brace");
  CHECK(brief("static double f(double x) { return x; }") == "E0116 `static` delete static");
}

TEST_CASE("a list in round brackets inside a call becomes a list") {
  CHECK(brief("f((1, 2))") == "E0117 `(1, 2)` write [1, 2]");
}

TEST_CASE("braces inside a call become a list") {
  CHECK(brief("f(posJ({1, 2}), 3)") == "E0128 `{` write [1, 2]");
}

TEST_CASE("arrows and colons of other languages are explained") {
  CHECK(brief("let f = fn(x) => { return x }") == "E0118 `=>` delete the =>");
  CHECK(brief("x := 3\nlet y := 4\n") == "E0119 `:=` write var x = ...; E0119 `:=` write =");
}

TEST_CASE("missing separators are found where they belong") {
  CHECK(brief("print(a b)") == "E0120 `b` write a, b");
  CHECK(brief("let q = [0.1 0.2]") == "E0120 `0.2` write 0.1, 0.2");
  CHECK(brief("int[] z = {1 2}") == "E0120 `2` write 1, 2");
  CHECK(brief("print(1) print(2)") == "E0122 `print` write a `;` before it, or start a new line");
  CHECK(brief("let a = 1 let b = 2") == "E0122 `let` write a `;` before it, or start a new line");
}

TEST_CASE("jumps and declarations stand where they make sense") {
  CHECK(brief("if (true) { break }") == "E0121 `break`");
  CHECK(brief("switch (a) { case 1: break }") == "");
  CHECK(brief("switch (a) { case 1: continue }") == "E0121 `continue`");
  CHECK(brief("for (i in xs) { f(fn() { break }) }") == "E0121 `break`");
  CHECK(brief("for (i in xs) { parallel { break } }") == "E0121 `break`");
  CHECK(brief("return 3\nretry\n") == "E0121 `return`; E0121 `retry`");
  CHECK(brief("try { f() } catch (e) { if (a) retry }") == "");
  CHECK(brief("fn f() { when (a) { return } }") == "E0121 `return`");
  CHECK(brief("if (a) { fn f() { } }") ==
        "E0132 `fn` write let name = fn(...) { ... } for a function inside a block");
  CHECK(brief("{ struct P { a: int } }") == "E0132 `struct`");
}

TEST_CASE("a file that is not text is refused before it is read") {
  CHECK(brief(std::string("PNG\0\x01", 5)) ==
        "E0123 `` save the program as text with the encoding UTF-8");
  CHECK(brief("let \xE9 = 1") == "E0123 `` save the program as text with the encoding UTF-8");
  CHECK(brief("let \xED\xA0\x80 = 1") ==
        "E0123 `` save the program as text with the encoding UTF-8");
}

TEST_CASE("what does not fit is named, what is missing is named") {
  CHECK(brief("let x = * 3") == "E0128 `*`");
  CHECK(brief("let in = 3") == "E0128 `in` choose another name");
  CHECK(brief("else { x() }\nfoo()\n") == "E0128 `else`");
  CHECK(brief("let m = x until y") == "E0128 `until` write wait until ... to wait for a condition");
  CHECK(brief("let x =\nlet y = 3\nlet\nstruct\nimport\n") ==
        "E0129 ``; E0129 ``; E0129 ``; E0129 ``");
  CHECK(brief("let z: = 3") == "E0129 ``");
  CHECK(brief("try { x() }\nfinally\n") == "E0129 ``");
  CHECK(brief("print \"hello\"") == "E0129 `\"hello\"` write print(\"hello\")");
}

TEST_CASE("words of other languages are translated") {
  CHECK(brief("if (a and b) { x() }") == "E0130 `and` write &&");
  CHECK(brief("let q = not a") == "E0130 `not` write !");
  CHECK(brief("def f(x):\n") == "E0130 `def` write fn");
  CHECK(brief("If (a) { x() }") == "E0130 `If` write if");
  CHECK(brief("if (a) { x() }\nelif (b) { }\n") == "E0130 `elif` write else if");
  CHECK(brief("for (x of xs) { }") == "E0130 `of` write in");
  CHECK(brief("moveJ(p, time=2s)") == "E0130 `=` write time: 2s");
}

TEST_CASE("the left side of an assignment is a target, and named values come last") {
  CHECK(brief("joints() = 3") == "E0328 `joints()`");
  CHECK(brief("3 += 2; f()++; a[0].b = 1; a[1:2] = b") == "E0328 `3`; E0328 `f()`");
  CHECK(brief("moveJ(a: 1, b)") == "E0326 `b`");
}

TEST_CASE("a value on the line after a lone return gets advice") {
  CHECK(brief("fn f() {\n  return\n  3\n}\n") ==
        "W0705 `3` write the value on the line of `return`");
  CHECK(brief("fn f() {\n  if (a) return\n  x = 3\n}\n") == "");
}

TEST_CASE("at most ten messages are given") {
  std::string text;
  for (int i = 0; i < 50; ++i) text += "let a = 1 1\n";
  CHECK(messages_of(Source("test.rbt", text)).size() == 10);
}

TEST_CASE("a fix that is sure leads to a program without that mistake") {
  for (const char* text :
       {"wait(2 s)", "if d > 0.45 { stop() }", "if (a = b) { f() }", "double[] q = (0.0, 0.5);",
        "x := 3", "if (a and b) { f() }", "let f = fn(x) => { return x }", "let a = 0,5",
        "f(\u201Cx\u201D)", "moveJ(p, time=2s)"}) {
    const Source source("test.rbt", text);
    const std::vector<Diagnostic> messages = messages_of(source);
    REQUIRE(messages.size() == 1);
    REQUIRE(messages[0].fix->confidence == Confidence::kSure);
    std::string fixed = text;
    for (auto edit = messages[0].fix->edits.rbegin(); edit != messages[0].fix->edits.rend();
         ++edit) {
      fixed.replace(edit->span.begin, edit->span.end - edit->span.begin, edit->text);
    }
    CHECK(brief(fixed) == "");
  }
}

}  // namespace
}  // namespace armlet::lang
