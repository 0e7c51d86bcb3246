#include <doctest/doctest.h>

#include "armlet/interpreter/engine.hpp"
#include "syntax/tokens/lex.hpp"
#include "syntax/tokens/line_ends.hpp"

namespace armlet::lang {
namespace {

// The tokens of a text, separated by blanks; an inserted end of a statement is shown as `#`.
std::string filtered(const std::string& text) {
  const Source source("test.rbt", text);
  DiagnosticSink sink;
  const Lexed lexed = lex(source, program_range(source), sink, {});
  REQUIRE(lexed.ok);
  std::string out;
  for (const Token& token : insert_line_ends(lexed.tokens)) {
    if (token.type == kEndOfText) break;
    if (!out.empty()) out += ' ';
    out += token.inserted ? "#" : std::string(source.slice({token.begin, token.end, 0}));
  }
  return out;
}

TEST_CASE("a line break ends a statement after what can end one") {
  CHECK(filtered("a\nb") == "a # b #");
  CHECK(filtered("x = 1\ny = 2.5\nz = 3mm\ns = \"t\"\nb = true\n") ==
        "x = 1 # y = 2.5 # z = 3mm # s = \"t\" # b = true #");
  CHECK(filtered("i++\nj--\nreturn\nbreak\ncontinue\nretry\nf()\na[0]") ==
        "i ++ # j -- # return # break # continue # retry # f ( ) # a [ 0 ] #");
  CHECK(filtered("let x: int\nlet y = record\n") == "let x : int # let y = record #");
}

TEST_CASE("an explicit semicolon is not doubled") {
  CHECK(filtered("a;\nb;") == "a ; b ;");
  CHECK(filtered("{ a; }") == "{ a ; } #");
}

TEST_CASE(
    "a line that starts with an operator, a dot or an opening bracket continues the line above") {
  CHECK(filtered("x = 1\n  + 2") == "x = 1 + 2 #");
  CHECK(filtered("a\n.b\n(c)\n[d]\n? e\n: f") == "a . b ( c ) [ d ] ? e : f #");
  CHECK(filtered("x\n= 1\ny\n+= 2") == "x = 1 # y += 2 #");
  CHECK(filtered("a\n\\ b\n.* c\n./ d\n.^ e\n% f\n^ g") == "a \\ b .* c ./ d .^ e % f ^ g #");
  CHECK(filtered("a\n&& b\n|| c\n== d\n!= e\n<= f") == "a && b || c == d != e <= f #");
  CHECK(filtered("moveL(p)\n  until c") == "moveL ( p ) until c #");
  CHECK(filtered("import \"a.rbt\"\n as b") == "import \"a.rbt\" as b #");
}

TEST_CASE("a line that starts with another mark does not continue") {
  CHECK(filtered("a\n!b") == "a # ! b #");
  CHECK(filtered("a\n++b") == "a # ++ b #");
}

TEST_CASE("a line that ends with an operator goes on") {
  CHECK(filtered("x =\n1") == "x = 1 #");
  CHECK(filtered("x = 1 +\n2\n") == "x = 1 + 2 #");
  CHECK(filtered("f(a,\n  b)\n") == "f ( a , b ) #");
}

TEST_CASE("nothing is inserted inside round and square brackets") {
  CHECK(filtered("f(a\n)\ng") == "f ( a ) # g #");
  CHECK(filtered("[1\n2]") == "[ 1 2 ] #");
}

TEST_CASE("a block inside brackets has statements again") {
  CHECK(filtered("f(fn() {\n a\n b\n})") == "f ( fn ( ) { a # b # } ) #");
}

TEST_CASE("the header of a statement is not its end") {
  CHECK(filtered("if (a)\nb") == "if ( a ) b #");
  CHECK(filtered("while (a)\n{ b }") == "while ( a ) { b # } #");
  CHECK(filtered("for (x in xs)\n{ b }") == "for ( x in xs ) { b # } #");
  CHECK(filtered("switch (a)\n{ default: b }") == "switch ( a ) { default : b # } #");
  CHECK(filtered("when (a)\n{ b }\nevery (c)\n{ d }") ==
        "when ( a ) { b # } # every ( c ) { d # } #");
  CHECK(filtered("try { a }\ncatch (e)\n{ b }\nfinally { c }") ==
        "try { a # } catch ( e ) { b # } finally { c # } #");
}

TEST_CASE("else stays with its if, with and without braces") {
  CHECK(filtered("if (a) b\nelse c") == "if ( a ) b # else c #");
  CHECK(filtered("if (a) b else c") == "if ( a ) b # else c #");
  CHECK(filtered("if (a) { b } else { c }") == "if ( a ) { b # } else { c # } #");
  CHECK(filtered("if (a) { b }\nelse\n{ c }") == "if ( a ) { b # } else { c # } #");
}

TEST_CASE("do and while are one statement") {
  CHECK(filtered("do { a }\nwhile (b)\nc") == "do { a # } while ( b ) # c #");
  CHECK(filtered("do { a } while (b)") == "do { a # } while ( b ) #");
  CHECK(filtered("{ a }\nwhile (b)\nc") == "{ a # } # while ( b ) c #");
}

TEST_CASE("a brace on a new line belongs to a declaration or a block with settings") {
  CHECK(filtered("fn f()\n{ a }") == "fn f ( ) { a # } #");
  CHECK(filtered("void f()\n{ a }") == "void f ( ) { a # } #");
  CHECK(filtered("double f(double x)\n{ a }") == "double f ( double x ) { a # } #");
  CHECK(filtered("pal.Pallet[] f()\n{ a }") == "pal . Pallet [ ] f ( ) { a # } #");
  CHECK(filtered("robot scara\n{ a: 1 }") == "robot scara { a : 1 # } #");
  CHECK(filtered("struct P\n{ a: int }\nenum E\n{ A }") ==
        "struct P { a : int # } # enum E { A # } #");
  CHECK(filtered("with (speed: 1)\n{ a }\npath\n{ b }") ==
        "with ( speed : 1 ) { a # } # path { b # } #");
  CHECK(filtered("test \"t\"\n{ a }") == "test \"t\" { a # } #");
}

TEST_CASE("a brace on a new line opens a block after any other statement") {
  CHECK(filtered("f()\n{ a }") == "f ( ) # { a # } #");
  CHECK(filtered("let x = 1\n{ a }") == "let x = 1 # { a # } #");
  CHECK(filtered("double x = 1\n{ a }") == "double x = 1 # { a # } #");
  CHECK(filtered("fn f(x) => x\n{ a }") == "fn f ( x ) => x # { a # } #");
}

TEST_CASE("a default value does not separate a function from its brace") {
  CHECK(filtered("fn f(x = 1)\n{ a }") == "fn f ( x = 1 ) { a # } #");
}

TEST_CASE("the braces of a list hold no statements") {
  CHECK(filtered("double[] a = {\n 1,\n 2\n}\nb") == "double [ ] a = { 1 , 2 } # b #");
  CHECK(filtered("double[][] a = {{1\n}, {2\n}\n}") == "double [ ] [ ] a = { { 1 } , { 2 } } #");
  CHECK(filtered("x = new double[] {1\n}\ny = new pal.P[][]\n{\n}") ==
        "x = new double [ ] { 1 } # y = new pal . P [ ] [ ] { } #");
}

TEST_CASE("a block in a block is not a list") {
  CHECK(filtered("{\n{\na\n}\n}") == "{ { a # } # } #");
}

TEST_CASE("statements after a case are counted from the colon") {
  CHECK(filtered("switch (a) {\ncase 1:\nrobot r\n{ a: 1 }\n}") ==
        "switch ( a ) { case 1 : robot r { a : 1 # } # } #");
}

TEST_CASE("comments and all kinds of line breaks are seen as such") {
  CHECK(filtered("a // note\r\nb /* more */\rc") == "a # b # c #");
  CHECK(filtered("a /* over\ntwo lines */ + b") == "a + b #");
}

TEST_CASE("an inserted token has no text and stands behind the one before it") {
  const Source source("test.rbt", "ab  \n c");
  DiagnosticSink sink;
  const Tokens tokens = insert_line_ends(lex(source, program_range(source), sink, {}).tokens);
  REQUIRE(tokens.size() == 5);
  CHECK(tokens[1].inserted);
  CHECK(tokens[1].begin == 2);
  CHECK(tokens[1].end == 2);
}

}  // namespace
}  // namespace armlet::lang
