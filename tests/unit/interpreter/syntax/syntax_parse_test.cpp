#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <thread>

#include "armlet/interpreter/render.hpp"
#include "syntax/tokens/lex.hpp"
#include "syntax/tokens/line_ends.hpp"
#include "syntax_dump.hpp"

namespace armlet::lang {
namespace {

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::filesystem::path> language_blocks() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry :
       std::filesystem::directory_iterator(ARMLET_REFERENCE_DIR "/language_blocks")) {
    paths.push_back(entry.path());
  }
  std::ranges::sort(paths);
  return paths;
}

// The same program with every inserted `;` written out.
std::string with_semicolons(const std::string& text) {
  const Source source("test.rbt", text);
  DiagnosticSink sink;
  std::string out;
  std::size_t copied = 0;
  for (const Token& token : insert_line_ends(lex(source, program_range(source), sink, {}).tokens)) {
    if (!token.inserted) continue;
    out += text.substr(copied, token.begin - copied) + ';';
    copied = token.begin;
  }
  return out + text.substr(copied);
}

struct Reading {
  SourceSet sources;
  Arena arena;
  DiagnosticSink sink;
  Parsed parsed;

  explicit Reading(const std::string& text)
      : parsed(parse(sources.add("test.rbt", text), arena, sink)) {}

  template <class T>
  const T& statement(std::size_t i) const {
    return parsed.statements.at(i)->as<T>();
  }
  // The value of `let x = ...` in statement `i`.
  template <class T>
  const T& init(std::size_t i) const {
    return statement<ast::VarStmt>(i).declarators[0].init->as<T>();
  }
  std::string_view slice(Span span) const { return sources.slice(span); }
};

TEST_CASE("every program of the language reference parses") {
  CHECK(language_blocks().size() == 21);
  for (const auto& path : language_blocks()) {
    INFO(path.filename().string());
    const Reading reading(read_file(path));
    CHECK(reading.parsed.ok);
    CHECK_FALSE(reading.parsed.statements.empty());
  }
}

TEST_CASE("a program with and without semicolons at its line ends has the same tree") {
  for (const auto& path : language_blocks()) {
    INFO(path.filename().string());
    const std::string text = read_file(path);
    CHECK(dump(text) == dump(with_semicolons(text)));
  }
}

// The dump of a value without the parentheses that the reader wrote.
std::string bound(const std::string& value) {
  const Reading reading("let x = " + value);
  REQUIRE(reading.parsed.ok);
  const auto strip = [](auto&& self, ast::Expr* expr) -> void {
    expr->parens = 0;
    if (expr->kind == ast::ExprKind::kBinary) {
      self(self, static_cast<ast::BinaryExpr*>(expr)->left);
      self(self, static_cast<ast::BinaryExpr*>(expr)->right);
    } else if (expr->kind == ast::ExprKind::kUnary) {
      self(self, static_cast<ast::UnaryExpr*>(expr)->operand);
    }
  };
  strip(strip, reading.statement<ast::VarStmt>(0).declarators[0].init);
  return dump(reading.parsed);
}

TEST_CASE("operators bind as the reference says") {
  CHECK(bound("-2^2") == bound("-(2^2)"));
  CHECK(bound("2^3^4") == bound("2^(3^4)"));
  CHECK(bound("2 .^ 3 .^ 4") == bound("(2 .^ 3) .^ 4"));
  CHECK(bound("a - b - c") == bound("(a - b) - c"));
  CHECK(bound("a + b * c") == bound("a + (b * c)"));
  CHECK(bound("a \\ b .* c") == bound("(a \\ b) .* c"));
  CHECK(bound("a < b == c > d") == bound("(a < b) == (c > d)"));
  CHECK(bound("a || b && c") == bound("a || (b && c)"));
  CHECK(bound("!a && -b < c") == bound("(!a) && ((-b) < c)"));
}

TEST_CASE("numbers keep their value") {
  const Reading reading(
      "let a = 1_000; let b = 0x1F; let c = 7L; let d = .5; let e = 2.; let f = 1e-3; let g = 3f; "
      "let h = -9223372036854775808");
  REQUIRE(reading.parsed.ok);
  CHECK(reading.init<ast::IntExpr>(0).value == 1000);
  CHECK(reading.init<ast::IntExpr>(1).value == 31);
  CHECK(reading.init<ast::IntExpr>(2).value == 7);
  CHECK(reading.init<ast::RealExpr>(3).value == 0.5);
  CHECK(reading.init<ast::RealExpr>(4).value == 2.0);
  CHECK(reading.init<ast::RealExpr>(5).value == 1e-3);
  CHECK(reading.init<ast::RealExpr>(6).value == 3.0);
  CHECK(reading.init<ast::IntExpr>(7).value == std::numeric_limits<std::int64_t>::min());
}

TEST_CASE("quantities are in SI and do not stop inside a word") {
  const Reading reading(
      "let a = 250mm; let b = 100mm/s; let c = 10mm/speed; let d = 9.81m/s^2; let e = 90\u00B0");
  REQUIRE(reading.parsed.ok);
  CHECK(reading.init<ast::QuantityExpr>(0).si == doctest::Approx(0.25));
  CHECK(reading.init<ast::QuantityExpr>(1).dim == dims::kSpeed);
  CHECK(reading.init<ast::QuantityExpr>(1).unit == "mm/s");
  const auto& quotient = reading.init<ast::BinaryExpr>(2);
  CHECK(quotient.op == ast::BinaryOp::kDiv);
  CHECK(reading.slice(quotient.left->span) == "10mm");
  CHECK(quotient.right->as<ast::NameExpr>().name == "speed");
  CHECK(reading.init<ast::QuantityExpr>(3).dim == dims::kAccel);
  CHECK(reading.init<ast::QuantityExpr>(4).dim == dims::kAngle);
}

TEST_CASE("escapes are decoded") {
  const Reading reading(R"(let a = "x\n\t\\\"\'\0\u00e9"; let b = 'it"s')");
  REQUIRE(reading.parsed.ok);
  CHECK(reading.init<ast::TextExpr>(0).value == std::string_view("x\n\t\\\"'\0\u00e9", 9));
  CHECK(reading.init<ast::TextExpr>(1).value == "it\"s");
}

TEST_CASE("formatted texts have parts with spans in the program") {
  const Reading reading(R"(let a = f"joint {j + 1} at {q[j]:.1f deg} {{x}} {(c ? 'a:b' : d):g}")");
  REQUIRE(reading.parsed.ok);
  const auto& text = reading.init<ast::FormattedExpr>(0);
  REQUIRE(text.pieces.size() == 3);
  CHECK(text.texts[0] == "joint ");
  CHECK(text.texts[2] == " {x} ");
  CHECK(reading.slice(text.pieces[0].value->span) == "j + 1");
  CHECK(text.pieces[0].format.style.digits == -1);
  CHECK(text.pieces[1].format.style.digits == 1);
  CHECK(text.pieces[1].format.style.notation == 'f');
  CHECK(text.pieces[1].format.unit == "deg");
  CHECK(text.pieces[2].format.style.notation == 'g');
}

TEST_CASE("spans are bytes and positions are characters") {
  const Reading reading("let \u03B1\u03B2 = 1; let gr\u00FC\u00DFe = \u03B1\u03B2");
  REQUIRE(reading.parsed.ok);
  const auto& second = reading.statement<ast::VarStmt>(1);
  CHECK(second.declarators[0].name.text == "gr\u00FC\u00DFe");
  CHECK(reading.sources.position(second.declarators[0].init->span) == Position{1, 25});
}

TEST_CASE("a byte-order mark and a first line for the shell are skipped") {
  const Reading reading("\xEF\xBB\xBF#!/usr/bin/env armlet\nprint(1)\n");
  REQUIRE(reading.parsed.ok);
  CHECK(reading.sources.position(reading.parsed.statements[0]->span) == Position{2, 1});
}

TEST_CASE("comments above a declaration are its documentation") {
  const Reading reading(
      "/// One.\n///  Two.\nfn f() { }\nlet a = 1 /// not this\nlet b = 2\n// nor this\nlet c = "
      "3\n");
  REQUIRE(reading.parsed.ok);
  CHECK(reading.statement<ast::FunctionStmt>(0).doc == "One.\n Two.");
  CHECK(reading.statement<ast::VarStmt>(2).doc.empty());
  CHECK(reading.statement<ast::VarStmt>(3).doc.empty());
  CHECK(reading.parsed.comments.size() == 4);
}

TEST_CASE("classic and modern spellings of a declaration have the same parts") {
  const Reading reading(
      "final double[] q[] = {1}, r; let k: force/length^2 = 0; double mean(double[] a) { return 0; "
      "}");
  REQUIRE(reading.parsed.ok);
  const auto& classic = reading.statement<ast::VarStmt>(0);
  CHECK(classic.fixed);
  CHECK(classic.declarators.size() == 2);
  CHECK(classic.declarators[0].type->element->form == ast::TypeForm::kArray);
  CHECK(classic.declarators[1].type->element->form == ast::TypeForm::kPrimitive);
  const auto& factors = reading.statement<ast::VarStmt>(1).declarators[0].type->factors;
  REQUIRE(factors.size() == 2);
  CHECK(factors[1].exponent == -2);
  CHECK(reading.statement<ast::FunctionStmt>(2).classic);
}

TEST_CASE("soft words are names where the grammar does not need them") {
  CHECK(Reading("let test = 1; let record = test; path = record; as(path)").parsed.ok);
}

TEST_CASE("a statement with a mistake does not hide the next") {
  const Reading reading(
      "let a = 1 1\nlet b = 2\nfn f() {\n    g(a b)\n    h()\n    let c =\n}\nlet d = 3 3\n");
  CHECK_FALSE(reading.parsed.ok);
  CHECK(reading.sink.all().size() == 4);
  CHECK(reading.parsed.statements.size() == 1);
}

TEST_CASE("the prompt waits for open brackets and unfinished lines") {
  const auto complete = [](const char* text) { return is_complete(Source("prompt", text)); };
  CHECK(complete(""));
  CHECK(complete("let a = 1"));
  CHECK(complete("f()"));
  CHECK_FALSE(complete("let a ="));
  CHECK_FALSE(complete("for (i in range(3)) {"));
  CHECK_FALSE(complete("f(1,"));
  CHECK(complete("f(1))"));
}

TEST_CASE("two threads can parse at once") {
  std::string first;
  std::string second;
  std::jthread other([&] { first = dump("let a = f(1, x: 2)\n"); });
  second = dump("let a = f(1, x: 2)\n");
  other.join();
  CHECK(first == second);
}

}  // namespace
}  // namespace armlet::lang
