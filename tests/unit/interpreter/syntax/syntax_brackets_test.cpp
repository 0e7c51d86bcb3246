#include <doctest/doctest.h>

#include "armlet/interpreter/engine.hpp"
#include "syntax/mistakes/brackets.hpp"
#include "syntax/tokens/lex.hpp"

namespace armlet::lang {
namespace {

// "CODE line:column | fix", or "fine".
std::string checked(const std::string& text) {
  const Source source("test.rbt", text);
  DiagnosticSink sink;
  const std::optional<Diagnostic> found =
      check_brackets(source, lex(source, program_range(source), sink, {}).tokens);
  if (!found) return "fine";
  const Position at = source.position(found->mark.span.begin);
  return found->code + ' ' + std::to_string(at.line) + ':' + std::to_string(at.column) + " | " +
         found->fix->text;
}

TEST_CASE("matching brackets are fine whatever the indentation") {
  CHECK(checked("") == "fine");
  CHECK(checked("f(a[{1}])\n      {\n}\n") == "fine");
}

TEST_CASE("an open round bracket ends before the next statement") {
  CHECK(checked("moveJ(above(p, 60mm), time: 2s\ngrasp(cube)\n") ==
        "E0110 1:6 | add `)` at the end of line 1");
  CHECK(checked("moveJ(above(p, time: 2s;\nfoo();\n") == "E0110 1:12 | add `)` before the `;`");
  CHECK(checked("let a = [1, 2\nlet b = 3\n") == "E0110 1:9 | add `]` at the end of line 1");
  CHECK(checked("f(a,\n  b,\n  c\ng()\n") == "E0110 1:2 | add `)` at the end of line 3");
  CHECK(checked("print((1 + 2") == "E0110 1:7 | add `)` at the end of line 1");
}

TEST_CASE("an open round bracket inside a block does not blame the block") {
  CHECK(checked("fn f() {\n    x(\n}\nfn g() {\n}\n") ==
        "E0110 2:6 | add `)` at the end of line 2");
  CHECK(checked("if (a { b() }\nc()\n") == "E0110 1:4 | add `)` at the end of line 1");
}

TEST_CASE("the indentation shows which block is open") {
  CHECK(checked("for (i in range(3)) {\n    a()\nb()\n") == "E0111 1:21 | add `}` before line 3");
  CHECK(checked("fn f() {\n    if (a) {\n        x()\n}\nfn g() {\n    y()\n}\n") ==
        "E0111 2:12 | add `}` before line 4");
  CHECK(checked("fn f() {\n    a()\n") == "E0111 1:8 | add `}` at the end of the program");
}

TEST_CASE("a bracket too many is found, by its indentation if that shows it") {
  CHECK(checked("print(1))\n") == "E0131 1:9 | delete it");
  CHECK(checked("fn f() {\n    if (a) {\n        x()\n    }\n    }\n    y()\n}\n") ==
        "E0131 5:5 | delete it");
  CHECK(checked("}\n") == "E0131 1:1 | delete it");
}

TEST_CASE("a bracket of the wrong kind is replaced") {
  CHECK(checked("let a = [1, 2)\n") == "E0131 1:14 | write `]`");
  CHECK(checked("f(1]\n") == "E0131 1:4 | write `)`");
}

}  // namespace
}  // namespace armlet::lang
