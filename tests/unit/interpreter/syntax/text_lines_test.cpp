// Texts between three quotes: what they say, and that the formatter leaves them as they are.
#include "syntax/build/text_lines.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

#include "armlet/interpreter/format.hpp"
#include "base/quotes.hpp"
#include "syntax/parse.hpp"
#include "vm_fixture.hpp"

namespace armlet::lang {
namespace {

// A line of letters, quotes and blanks, with never more than two quotes behind each other.
std::string some_line(std::mt19937& random, bool begins_with_a_letter) {
  std::string out = begins_with_a_letter ? "a" : "";
  const auto count = random() % 12;
  for (std::size_t i = 0; i < count; ++i) {
    const char c = "ab \"\\{}'\t"[random() % 9];
    out += c == '"' && out.ends_with("\"\"") ? 'b' : c;
  }
  while (out.ends_with(' ') || out.ends_with('\t')) out.pop_back();
  return out;
}

std::string joined(const std::vector<std::string>& lines, const std::string& between) {
  std::string out;
  for (std::size_t i = 0; i < lines.size(); ++i) out += (i > 0 ? between : "") + lines[i];
  return out;
}

std::string with_backslashes_twice(const std::string& text) {
  std::string out;
  for (const char c : text) out += std::string(c == '\\' ? 2 : 1, c);
  return out;
}

}  // namespace

TEST_CASE("a text over several lines is its lines without the blanks that all begin with") {
  std::mt19937 random(20261128);
  for (int round = 0; round < 300; ++round) {
    std::vector<std::string> lines = {some_line(random, true)};
    const auto more = random() % 4;
    for (std::size_t i = 0; i < more; ++i) lines.push_back(some_line(random, false));
    const std::string indentation(random() % 9, random() % 4 == 0 ? '\t' : ' ');
    const std::string line_break = random() % 3 == 0 ? "\r\n" : "\n";
    std::string program = "print(\"\"\"" + line_break;
    for (const std::string& line : lines)
      program += (line.empty() ? "" : indentation) + with_backslashes_twice(line) + line_break;
    program += indentation + "\"\"\")\n";
    CAPTURE(program);
    CHECK(output_of(program) == joined(lines, "\n") + '\n');
    SourceSet sources;
    const Formatted formatted = format_program(sources.add("test.rbt", program));
    REQUIRE(formatted.text.has_value());
    CHECK(output_of(*formatted.text) == joined(lines, "\n") + '\n');
  }
}

TEST_CASE("the lines of a text keep what they have in addition to the common indentation") {
  CHECK(output_of("print(\"\"\"abc\ndef\"\"\")") == "abc\ndef\n");
  CHECK(output_of("print(\"\"\"\n    a\n      b\n\n    c\"\"\")") == "a\n  b\n\nc\n");
  CHECK(output_of("print(\"\"\"\n    a\n  \"\"\")") == "  a\n");
  CHECK(output_of("print(\"\"\"  a\n    b\n  c\"\"\")") == "  a\n  b\nc\n");
  CHECK(output_of("print(\"\"\"\n\ta\n    b\n\"\"\")") == "\ta\n    b\n");
  CHECK(output_of("print(\"\"\"\"\"\" + \"x\")") == "x\n");
  CHECK(output_of("print(\"\"\"\n\"\"\" + \"x\")") == "x\n");
  CHECK(output_of("print(\"\"\"say \"\"yes\"\"!\"\"\")") == "say \"\"yes\"\"!\n");
}

TEST_CASE("values stand in texts over several lines") {
  CHECK(
      output_of(
          "let n = 3\nprint(f\"\"\"\n    n is {n},\n      and {\"twice\"}: {2 * n}\n    \"\"\")") ==
      "n is 3,\n  and twice: 6\n");
}

TEST_CASE("the quotes of a text are those that it is written with") {
  CHECK(inside_quotes("\"abc\"") == "abc");
  CHECK(inside_quotes("'abc'") == "abc");
  CHECK(inside_quotes("f\"abc\"") == "abc");
  CHECK(inside_quotes("\"\"\"abc\"\"\"") == "abc");
  CHECK(inside_quotes("f\"\"\"abc\"\"\"") == "abc");
  CHECK(inside_quotes("\"\"") == "");
  CHECK(inside_quotes("\"\"\"") == "");
}

TEST_CASE("an entry goes on while its text over several lines is open") {
  CHECK_FALSE(is_complete(Source("test.rbt", "let s = \"\"\"\n    abc\n")));
  CHECK_FALSE(is_complete(Source("test.rbt", "print(f\"\"\"abc")));
  CHECK(is_complete(Source("test.rbt", "let s = \"\"\"\n    abc\n    \"\"\"\n")));
  CHECK(is_complete(Source("test.rbt", "let s = \"abc\n")));
}

}  // namespace armlet::lang
