// Texts that are made to break a parser end with a message.

#include <doctest/doctest.h>

#include "syntax/parse.hpp"

namespace armlet::lang {
namespace {

constexpr int kMany = 200'000;

std::string times(const char* text, int count) {
  std::string out;
  for (int i = 0; i < count; ++i) out += text;
  return out;
}

// The code of the first message, "" if there is none.
std::string code_of(const std::string& text, const ParseLimits& limits = {}) {
  const Source source("test.rbt", text);
  Arena arena;
  DiagnosticSink sink;
  const Parsed parsed = parse(source, arena, sink, limits);
  const std::vector<Diagnostic> messages = sink.take_sorted();
  CHECK(parsed.ok == messages.empty());
  return messages.empty() ? "" : messages[0].code;
}

TEST_CASE("ten megabytes of open brackets are refused at the limit of nesting") {
  CHECK(code_of(std::string(10'000'000, '(')) == "E0125");
}

TEST_CASE("every kind of nesting has a limit") {
  const auto nested = [](const std::string& head, const char* open, const char* middle,
                         const char* close) {
    return code_of(head + times(open, kMany) + middle + times(close, kMany));
  };
  CHECK(nested("x = ", "(", "1", ")") == "E0125");
  CHECK(nested("", "{", "", "}") == "E0125");
  CHECK(nested("x = ", "[", "", "]") == "E0125");
  CHECK(nested("double x = ", "{", "", "}") == "E0125");
  CHECK(nested("x = ", "- ", "1", "") == "E0125");
  CHECK(nested("x = ", "!", "a", "") == "E0125");
  CHECK(nested("x = ", "(int) ", "1", "") == "E0125");
  CHECK(nested("x = ", "2^", "1", "") == "E0125");
  CHECK(nested("x = ", "a ? b : ", "1", "") == "E0125");
  CHECK(nested("x = ", "a ? ", "1", " : b") == "E0125");
  CHECK(nested("x = ", "fn() => ", "1", "") == "E0125");
  CHECK(nested("x = ", "fn() { return ", "1", "}") == "E0125");
  CHECK(nested("if (a) x() ", "else if (a) x() ", "", "") == "E0125");
  CHECK(nested("", "while (a) ", "x()", "") == "E0125");
  CHECK(nested("let x: ", "fn() -> ", "int", "") == "E0125");
  CHECK(nested("x = new int", "[]", "{}", "") == "E0125");
}

TEST_CASE("chains of operators and suffixes have a limit") {
  CHECK(code_of("x = " + times("1 + ", kMany) + "1") == "E0125");
  CHECK(code_of("x = " + times("a.", kMany) + "a") == "E0125");
  CHECK(code_of("x = f" + times("()", kMany)) == "E0125");
  CHECK(code_of("x = f" + times("[0]", kMany)) == "E0125");
  CHECK(code_of("x = " + times("1 + ", 900) + "1") == "");
}

TEST_CASE("chains inside brackets do not escape the limit of depth") {
  const std::string chain = times(" + 1", 500);
  CHECK(code_of("x = " + times("(", 100) + "1" + times((chain + ")").c_str(), 100)) == "E0125");
}

TEST_CASE("what is long without being deep is no problem") {
  CHECK(code_of("x = [" + times("1,", kMany) + "1]") == "");
  CHECK(code_of("f(" + times("1,", kMany) + "1)") == "");
  CHECK(code_of(times("x = ", kMany) + "1") == "");
  CHECK(code_of(times("x = 1\n", kMany)) == "");
  CHECK(code_of("switch (x) {" + times("case 1: ", kMany) + "}") == "");
  CHECK(code_of("print(f\"" + times("{x}", 10'000) + "\")") == "");
  CHECK(code_of(std::string(1'000'000, ';')) == "");
  CHECK(code_of(std::string(5'000'000, 'a')) == "");
  CHECK(code_of("x = \"" + std::string(5'000'000, 'a') + '"') == "");
}

TEST_CASE("hundreds of thousands of mistakes take no longer than one") {
  CHECK(code_of(std::string(1'000'000, '@')) == "E0104");
  CHECK(code_of(times("@\n", kMany)) == "E0104");
  CHECK(code_of(std::string(1'000'000, ')')) == "E0131");
  CHECK(code_of("/*" + std::string(1'000'000, '/')) == "E0106");
  CHECK(code_of(times("let let\n", kMany)) == "E0128");
}

TEST_CASE("the size of a program has a limit") {
  CHECK(code_of("print(1)\n", {.bytes = 5}) == "E0124");
  CHECK(code_of("print(1, 2, 3)\n", {.tokens = 5}) == "E0124");
  CHECK(code_of("print((((1))))\n", {.nesting = 3}) == "E0125");
}

}  // namespace
}  // namespace armlet::lang
