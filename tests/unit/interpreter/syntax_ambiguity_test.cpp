// Random sentences of grammar/RbtParser.g4, parsed with ANTLR's exact detection of ambiguities.

#include <doctest/doctest.h>

#undef WHEN  // of doctest; the parser has a function of that name
#include <RbtParser.h>

#include <cctype>
#include <fstream>
#include <map>
#include <memory>
#include <random>
#include <sstream>

#include "syntax/token_feed.hpp"

namespace armlet::lang {
namespace {

// A piece of a rule: a token, a rule, a sequence or a choice; repeated or not.
struct Piece {
  enum class Kind { kToken, kRule, kSequence, kChoice } kind = Kind::kSequence;
  char repeat = ' ';  // ' ' once, '?', '*' or '+'
  std::string name = {};
  std::vector<Piece> parts = {};
  int depth = 1000;  // rules that must at least be nested to end it
};

// The rules of a parser grammar, read from its text.
class Grammar {
 public:
  explicit Grammar(const std::string& text) : words_(split(text)) {
    while (at_ < words_.size()) read_rule();
    // The depth of each piece follows from the depths of its rules: repeat until nothing changes.
    for (bool changed = true; changed;) {
      changed = false;
      for (auto& [name, rule] : rules_) {
        const int before = rule.depth;
        measure(rule);
        changed = changed || rule.depth != before;
      }
    }
  }

  const Piece& rule(const std::string& name) const { return rules_.at(name); }
  std::size_t size() const { return rules_.size(); }

 private:
  static std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < text.size();) {
      const char c = text[i];
      if (text.compare(i, 2, "//") == 0) {
        i = std::min(text.find('\n', i), text.size());
      } else if (c == '{') {  // options and members
        for (int depth = 0; i < text.size(); ++i) {
          depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
          if (depth == 0) break;
        }
        ++i;
        words.pop_back();
      } else if (c == '<') {
        i = text.find('>', i) + 1;
      } else if (c == '@') {
        ++i;
      } else if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
        std::size_t end = i;
        while (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '_') ++end;
        words.push_back(text.substr(i, end - i));
        i = end;
      } else {
        if (std::isspace(static_cast<unsigned char>(c)) == 0) words.emplace_back(1, c);
        ++i;
      }
    }
    return words;
  }

  void read_rule() {
    if (words_[at_] == "parser") {  // parser grammar RbtParser;
      at_ += 4;
      return;
    }
    const std::string name = words_[at_];
    at_ += 2;
    rules_[name] = read_choice(";");
  }

  Piece read_choice(const std::string& end) {
    Piece choice{.kind = Piece::Kind::kChoice};
    choice.parts.emplace_back();
    for (; words_[at_] != end; ++at_) {
      const std::string& word = words_[at_];
      if (word == "|") {
        choice.parts.emplace_back();
      } else if (word == "#") {
        ++at_;
      } else if (word == "?" || word == "*" || word == "+") {
        choice.parts.back().parts.back().repeat = word[0];
      } else if (word == "(") {
        ++at_;
        Piece inner = read_choice(")");
        choice.parts.back().parts.push_back(std::move(inner));
      } else {
        const bool is_token = std::isupper(static_cast<unsigned char>(word[0])) != 0;
        choice.parts.back().parts.push_back(
            {.kind = is_token ? Piece::Kind::kToken : Piece::Kind::kRule, .name = word});
      }
    }
    if (end == ";") ++at_;
    return choice;
  }

  int measure(Piece& piece) {
    int depth = 0;
    if (piece.kind == Piece::Kind::kRule) depth = rules_.at(piece.name).depth + 1;
    if (piece.kind == Piece::Kind::kChoice) depth = 1000;
    for (Piece& part : piece.parts) {
      const int inner = measure(part);
      depth = piece.kind == Piece::Kind::kChoice ? std::min(depth, inner) : std::max(depth, inner);
    }
    piece.depth = depth;
    return piece.repeat == '?' || piece.repeat == '*' ? 0 : depth;
  }

  std::vector<std::string> words_;
  std::size_t at_ = 0;
  std::map<std::string, Piece> rules_;
};

class Writer {
 public:
  Writer(const Grammar& grammar, unsigned seed) : grammar_(grammar), random_(seed) {
    RbtParser parser(&nothing_);
    for (std::size_t type = 1; type <= parser.getVocabulary().getMaxTokenType(); ++type) {
      types_[parser.getVocabulary().getSymbolicName(type)] = static_cast<std::uint16_t>(type);
    }
  }

  // A program of a few statements.
  Tokens program() {
    tokens_.clear();
    const int statements = 1 + below(5);
    for (int i = 0; i < statements; ++i) write(grammar_.rule("stmt"), 12);
    add(kEndOfText);
    return tokens_;
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  void add(std::uint16_t type) {
    const auto place = static_cast<std::uint32_t>(tokens_.size());
    tokens_.push_back({.begin = place, .end = place + 1, .type = type});
  }

  // With no depth left, only what ends soonest.
  void write(const Piece& piece, int depth) {
    int times = 1;
    if (piece.repeat == '?') times = depth > 0 ? below(2) : 0;
    if (piece.repeat == '*') times = depth > 0 ? below(3) : 0;
    if (piece.repeat == '+') times = depth > 0 ? 1 + below(2) : 1;
    for (int i = 0; i < times; ++i) write_once(piece, depth);
  }

  void write_once(const Piece& piece, int depth) {
    switch (piece.kind) {
      case Piece::Kind::kToken:
        return add(types_.at(piece.name));
      case Piece::Kind::kRule:
        // Soft words are names too, but seldom.
        if (piece.name == "name" && below(8) != 0) return add(RbtParser::ID);
        return write(grammar_.rule(piece.name), depth - 1);
      case Piece::Kind::kSequence:
        for (const Piece& part : piece.parts) write(part, depth);
        return;
      case Piece::Kind::kChoice:
        return write(choose(piece, depth), depth);
    }
  }

  const Piece& choose(const Piece& choice, int depth) {
    std::vector<const Piece*> open;
    for (const Piece& part : choice.parts) {
      if (depth > 0 ? part.depth <= depth || part.depth == choice.depth
                    : part.depth == choice.depth)
        open.push_back(&part);
    }
    return *open[static_cast<std::size_t>(below(static_cast<int>(open.size())))];
  }

  const Grammar& grammar_;
  std::mt19937 random_;
  std::map<std::string, std::uint16_t> types_;
  Tokens tokens_;
  Tokens end_{{.type = kEndOfText}};
  TokenFeed nothing_{end_};
};

struct Reports : antlr4::BaseErrorListener {
  int mistakes = 0;
  int ambiguities = 0;
  int full_contexts = 0;

  void syntaxError(antlr4::Recognizer*, antlr4::Token*, size_t, size_t, const std::string&,
                   std::exception_ptr) override {
    ++mistakes;
  }
  void reportAmbiguity(antlr4::Parser*, const antlr4::dfa::DFA&, size_t, size_t, bool,
                       const antlrcpp::BitSet&, antlr4::atn::ATNConfigSet*) override {
    ++ambiguities;
  }
  void reportAttemptingFullContext(antlr4::Parser*, const antlr4::dfa::DFA&, size_t, size_t,
                                   const antlrcpp::BitSet&, antlr4::atn::ATNConfigSet*) override {
    ++full_contexts;
  }
};

std::string grammar_text() {
  std::ifstream file(ARMLET_ROOT "/grammar/RbtParser.g4");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string shown(const Tokens& tokens, RbtParser& parser) {
  std::string out;
  for (const Token& token : tokens) {
    if (token.type != kEndOfText) out += parser.getVocabulary().getSymbolicName(token.type) + ' ';
  }
  return out;
}

TEST_CASE("the grammar has no ambiguity, and one token of context is never needed") {
  const Grammar grammar(grammar_text());
  CHECK(grammar.size() <= 65);
  Writer writer(grammar, 1);
  std::size_t tokens = 0;
  for (int i = 0; i < 5000; ++i) {
    const Tokens program = writer.program();
    tokens += program.size();
    TokenFeed feed(program);
    RbtParser parser(&feed);
    Reports reports;
    parser.removeErrorListeners();
    parser.addErrorListener(&reports);
    parser.max_level = 100'000;
    parser.getInterpreter<antlr4::atn::ParserATNSimulator>()->setPredictionMode(
        antlr4::atn::PredictionMode::LL_EXACT_AMBIG_DETECTION);
    parser.program();
    const bool clean =
        reports.mistakes == 0 && reports.ambiguities == 0 && reports.full_contexts == 0;
    if (clean) continue;
    INFO(shown(program, parser));
    INFO("mistakes ", reports.mistakes, ", ambiguities ", reports.ambiguities, ", full contexts ",
         reports.full_contexts);
    REQUIRE(clean);
  }
  CHECK(tokens > 100'000);
}

}  // namespace
}  // namespace armlet::lang
