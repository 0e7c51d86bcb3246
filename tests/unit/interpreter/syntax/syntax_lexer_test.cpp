// The lexer by tables against the one that ANTLR generates from the same grammar.

#include <doctest/doctest.h>

#undef WHEN  // of doctest; the parser has a function of that name
#include <RbtLexer.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "armlet/core/random.hpp"
#include "armlet/interpreter/diagnostic.hpp"
#include "syntax/tokens/lex.hpp"

namespace armlet::lang {
namespace {

struct Found {
  std::size_t type, begin, end;  // bytes
  bool operator==(const Found&) const = default;
};

// Where each character begins, and the end.
std::vector<std::size_t> starts_of(const std::string& text) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) starts.push_back(i);
  }
  starts.push_back(text.size());
  return starts;
}

struct Both {
  std::vector<Found> tokens, comments;
  bool operator==(const Both&) const = default;
};

Both by_antlr(const std::string& text) {
  antlr4::ANTLRInputStream stream(text);
  RbtLexer lexer(&stream);
  lexer.removeErrorListeners();
  const std::vector<std::size_t> starts = starts_of(text);
  Both out;
  while (true) {
    const auto token = lexer.nextToken();
    if (token->getType() == antlr4::Token::EOF) return out;
    if (token->getType() == RbtLexer::NL) continue;
    auto& list = token->getChannel() == antlr4::Token::DEFAULT_CHANNEL ? out.tokens : out.comments;
    list.push_back(
        {token->getType(), starts[token->getStartIndex()], starts[token->getStopIndex() + 1]});
  }
}

// The grammar knows nothing of it: behind a bracket or comma and before a colon these words are
// names.
void name_arguments(std::vector<Found>& tokens) {
  for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
    const std::size_t before = tokens[i - 1].type, after = tokens[i + 1].type;
    const bool named =
        (before == RbtLexer::LPAREN || before == RbtLexer::COMMA) && after == RbtLexer::COLON;
    const bool word = tokens[i].type == RbtLexer::EVERY || tokens[i].type == RbtLexer::WHEN;
    if (named && word) tokens[i].type = RbtLexer::ID;
  }
}

Both by_tables(const std::string& text) {
  SourceSet sources;
  const Source& source = sources.add("random.rbt", text);
  DiagnosticSink sink(1'000'000);
  const Lexed lexed =
      lex(source, {0, static_cast<std::uint32_t>(text.size()), source.id()}, sink, ParseLimits());
  Both out;
  for (const Token& token : lexed.tokens) {
    if (token.type != kEndOfText) out.tokens.push_back({token.type, token.begin, token.end});
  }
  for (const Span& comment : lexed.comments) {
    const bool line = text.substr(comment.begin, 2) == "//";
    out.comments.push_back(
        {static_cast<std::size_t>(line ? RbtLexer::LINE_COMMENT : RbtLexer::BLOCK_COMMENT),
         comment.begin, comment.end});
  }
  return out;
}

// Pieces of which words, numbers, units, texts and comments are made, whole and broken.
const char* const kPieces[] = {
    "let",      "fn",     "int",    "in",         "e",   "E5",    "x",        "_",       "0",
    "1",        "12",     "1_0",    ".",          "..",  "0x",    "0xF",      "L",       "f",
    "d",        "deg",    "mm",     "m",          "s",   "um",    "\u00b0",   "\u00b5m", "\u03bcs",
    "kg",       "N",      "Nm",     "^",          "-",   "^2",    "/",        "*",       "/s",
    "*m",       "\"",     "'",      "\\",         "f\"", "{",     "}",        "(",       ")",
    "[",        "]",      ";",      ",",          ":",   "?",     "->",       "=>",      "=",
    "!",        "<",      ">",      "&",          "|",   "+",     "%",        "//",      "/*",
    "*/",       "\n",     "\r",     "\t",         " ",   "  ",    "\u00a0",   "\ufeff",  "\u00e4",
    "\u00d7",   "\u03b8", "\u20ac", "\U0001F916", "@",   "#",     "$",        "while",   "true",
    "parallel", "1.5",    "2.",     "3e",         "3e-", "90deg", "9.81m/s^2"};

bool begins_with(const std::vector<Found>& all, const std::vector<Found>& first) {
  return first.size() <= all.size() && std::equal(first.begin(), first.end(), all.begin());
}

std::string random_text(Random& random) {
  std::string text;
  const int pieces = 1 + static_cast<int>(random.uniform() * 14);
  for (int i = 0; i < pieces; ++i) {
    text += kPieces[static_cast<std::size_t>(random.uniform() * std::size(kPieces))];
  }
  return text;
}

}  // namespace

TEST_CASE("`every` and `when` are names where an argument has its name, and words elsewhere") {
  const auto types = [](const std::string& text) {
    std::vector<std::size_t> out;
    for (const Found& token : by_tables(text).tokens) out.push_back(token.type);
    return out;
  };
  CHECK(types("f(every: 1, when: x)")[2] == RbtLexer::ID);
  CHECK(types("f(every: 1, when: x)")[6] == RbtLexer::ID);
  CHECK(types("every (x) { }")[0] == RbtLexer::EVERY);
  CHECK(types("f(a, every)")[4] == RbtLexer::EVERY);
  CHECK(types("record r every (x) { }")[2] == RbtLexer::EVERY);
  CHECK(types("b ? when : c")[2] == RbtLexer::WHEN);
}

TEST_CASE("random texts have the tokens that the generated lexer finds") {
  Random random(5);
  std::size_t tokens = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::string text = random_text(random);
    // The stream of ANTLR drops a byte-order mark at the start.
    if (text.starts_with("\ufeff")) continue;
    Both expected = by_antlr(text);
    name_arguments(expected.tokens);
    INFO(text);
    const Both found = by_tables(text);
    tokens += found.tokens.size();
    // A comment that is not closed ends the reading of a program, and so this comparison.
    REQUIRE(begins_with(expected.tokens, found.tokens));
    REQUIRE(begins_with(expected.comments, found.comments));
  }
  CHECK(tokens > 100'000);
}

TEST_CASE(
    "the programs of the tests and the examples have the tokens that the generated lexer finds") {
  std::size_t programs = 0;
  for (const char* folder : {"/tests/scripts", "/examples"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::string(ARMLET_ROOT) + folder)) {
      if (entry.path().extension() != ".rbt") continue;
      std::ifstream file(entry.path(), std::ios::binary);
      const std::string text(std::istreambuf_iterator<char>(file), {});
      if (text.size() > 20'000 || text.starts_with("\ufeff") || text.find('\0') != text.npos)
        continue;
      SourceSet sources;
      DiagnosticSink sink(1'000'000);
      if (!check_text(sources.add("program.rbt", text), sink, ParseLimits())) continue;
      ++programs;
      INFO(entry.path().string());
      Both expected = by_antlr(text);
      name_arguments(expected.tokens);
      const Both found = by_tables(text);
      if (found.tokens.size() == expected.tokens.size()) CHECK(found == expected);
    }
  }
  CHECK(programs > 400);
}

}  // namespace armlet::lang
