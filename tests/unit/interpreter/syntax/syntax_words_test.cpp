// The table of words against the grammar.

#include <doctest/doctest.h>

#include "ast/marks.hpp"
#include "base/words.hpp"

#undef WHEN  // of doctest; the parser has a function of that name
#include <RbtLexer.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/unit.hpp"
#include "syntax/tokens/lex.hpp"

namespace armlet::lang {
namespace {

std::string grammar() {
  std::ostringstream text;
  text << std::ifstream(ARMLET_ROOT "/grammar/RbtLexer.g4").rdbuf();
  return text.str();
}

// What stands in single quotes, with \u00B5 as the letter.
std::vector<std::string> quoted(const std::string& text) {
  static const std::regex kText("'([^']*)'");
  static const std::regex kLetter(R"(\\u([0-9A-F]{4}))");
  std::vector<std::string> out;
  for (std::sregex_iterator it(text.begin(), text.end(), kText), end; it != end; ++it) {
    std::string found = (*it)[1];
    for (std::smatch letter; std::regex_search(found, letter, kLetter);) {
      const int code = std::stoi(letter[1], nullptr, 16);
      const std::string bytes = {static_cast<char>(0xC0 | code >> 6),
                                 static_cast<char>(0x80 | (code & 0x3F))};
      found = letter.prefix().str() + bytes + letter.suffix().str();
    }
    out.push_back(found);
  }
  return out;
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t at = text.find(begin);
  REQUIRE(at != std::string::npos);
  return text.substr(at, text.find(end, at) - at);
}

std::vector<std::size_t> types_of(const std::string& text) {
  SourceSet sources;
  const Source& source = sources.add("words.rbt", text);
  DiagnosticSink sink(1000);
  const Span all{0, static_cast<std::uint32_t>(text.size()), source.id()};
  std::vector<std::size_t> types;
  for (const Token& token : lex(source, all, sink, ParseLimits()).tokens) {
    if (token.type != kEndOfText) types.push_back(token.type);
  }
  return types;
}

}  // namespace

TEST_CASE("the words are those of the grammar, in its order") {
  const std::string words = between(grammar(), "- words\n", "- numbers\n");
  const std::vector<std::string> written = quoted(words);
  REQUIRE(written.size() == std::size(kWordRows));
  for (std::size_t i = 0; i < written.size(); ++i) CHECK(written[i] == kWordRows[i].text);
}

TEST_CASE("the marks are those of the grammar, in its order, and their tokens are their rows") {
  const std::vector<std::string> written = quoted(between(grammar(), "- marks\n", "// ---"));
  REQUIRE(written.size() == std::size(kMarkRows));
  for (std::size_t i = 0; i < written.size(); ++i) {
    const Mark& mark = kMarkRows[i];
    CAPTURE(mark.text);
    CHECK(written[i] == (mark.text == "\\" ? "\\\\" : mark.text));
    const std::vector<std::size_t> types = types_of(std::string(mark.text));
    REQUIRE(types.size() == 1);
    CHECK(&mark_of(types[0]) == &mark);
    CHECK(&find_mark(mark.text) == &mark);
  }
  for (const std::size_t type : types_of("x 1 2mm \"t\" let record"))
    CHECK(&mark_of(type) == &kNoMark);
  CHECK(&find_mark("**") == &kNoMark);
}

TEST_CASE("the token of a word is its row, and that of others has no row") {
  for (const Word& word : kWordRows) {
    CAPTURE(word.text);
    const std::vector<std::size_t> types = types_of(std::string(word.text));
    REQUIRE(types.size() == 1);
    const Word& row = word_of(static_cast<std::uint16_t>(types[0]));
    CHECK(row.kind == word.kind);
    CHECK((row.text == word.text) == !word.same_token);
    CHECK(find_word(word.text) == &word);
    CHECK(is_reserved_word(word.text) == (word.kind != WordKind::kSoft));
  }
  CHECK(RbtLexer::AS + 1 == kWordTokens);
  for (const std::size_t type : types_of("x 1 2mm \"t\" { } == .* retryx"))
    CHECK(word_of(static_cast<std::uint16_t>(type)).text.empty());
  CHECK(word_of(kEndOfText).text.empty());
  CHECK(find_word("") == nullptr);
}

TEST_CASE("the units are those of the grammar") {
  const std::vector<std::string> list = quoted(between(grammar(), "fragment UNIT\n", ";"));
  const std::set<std::string> written(list.begin(), list.end());
  CHECK(written.size() == list.size());
  std::set<std::string> known;
  for (const Unit& unit : all_units()) known.emplace(unit.name);
  CHECK(known == written);
}

}  // namespace armlet::lang
