#include "syntax_sentences.hpp"

#include <doctest/doctest.h>

#undef WHEN  // of doctest; the parser has a function of that name
#include <RbtParser.h>

#include <cctype>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include "syntax/parser/token_feed.hpp"
#include "syntax/tokens/lex.hpp"
#include "syntax/tokens/line_ends.hpp"
#include "syntax/tokens/token_kinds.hpp"

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

std::string grammar_text() {
  std::ifstream file(ARMLET_ROOT "/grammar/RbtParser.g4");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// One word for each kind of token is enough to show where tokens would run together.
std::vector<std::string> words_of(const std::string& kind) {
  if (kind == "ID") return {"a", "b2", "arm", "gr\u00F6\u00DFe", "mm", "f"};
  if (kind == "INT") return {"1", "0x1F", "1_000", "7L"};
  if (kind == "FLOAT") return {"0.5", ".5", "2.", "1e-3", "3f"};
  if (kind == "QUANTITY") return {"90deg", "250mm", "9.81m/s^2", "0.02kg*m^2", "5s"};
  if (kind == "STRING") return {"\"a b\"", "'c // d'", "\"\""};
  if (kind == "FSTRING") return {"f\"joint {a + 1}: {b:.1f deg}\"", "f\"{{}}\""};
  if (kind == "INT_T") return {"int", "long"};
  if (kind == "DOUBLE_T") return {"double", "float"};
  if (kind == "BOOL_T") return {"bool", "boolean"};
  return {};
}

class Writer {
 public:
  explicit Writer(unsigned seed) : grammar_(grammar_text()), random_(seed) {
    RbtParser parser(&nothing_);
    for (std::size_t type = 1; type <= parser.getVocabulary().getMaxTokenType(); ++type) {
      types_[parser.getVocabulary().getSymbolicName(type)] = static_cast<std::uint16_t>(type);
    }
  }

  Tokens program() {
    tokens_.clear();
    const int statements = 1 + below(5);
    for (int i = 0; i < statements; ++i) write(grammar_.rule("stmt"), 12);
    add(kEndOfText);
    return tokens_;
  }

  std::string text(const Tokens& tokens) {
    std::string out;
    for (const Token& token : tokens) {
      if (token.type != kEndOfText) out += word(token.type) + ' ';
    }
    return out;
  }

  std::size_t rules() const { return grammar_.size(); }

 private:
  std::string word(std::uint16_t type) {
    RbtParser parser(&nothing_);
    const std::string literal = parser.getVocabulary().getLiteralName(type);
    if (literal == "'\\\\'") return "\\";
    if (literal.size() > 2) return literal.substr(1, literal.size() - 2);
    const std::vector<std::string> words = words_of(parser.getVocabulary().getSymbolicName(type));
    return words[static_cast<std::size_t>(below(static_cast<int>(words.size())))];
  }

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

  const Grammar grammar_;
  std::mt19937 random_;
  std::map<std::string, std::uint16_t> types_;
  Tokens tokens_;
  Tokens end_{{.type = kEndOfText}};
  TokenFeed nothing_{end_};
};

// Writes the tokens of a text again.
class Roughener {
 public:
  Roughener(const std::string& text, unsigned seed) : source_("rough.rbt", text), random_(seed) {
    DiagnosticSink sink;
    tokens_ = lex(source_, program_range(source_), sink, {}).tokens;
  }

  std::string run() {
    choose_breaks();
    std::string out(source_.text().substr(0, program_range(source_).begin));
    if (!out.empty()) out += '\n';
    for (const Token& token : tokens_) {
      gap(out, token.line_break_before);
      out += source_.text().substr(token.begin, token.end - token.begin);
    }
    return out + (below(2) == 0 ? "\n" : "");
  }

 private:
  std::size_t below(std::size_t n) { return random_() % n; }

  // Breaks that end statements stay, others come and go unless they would end one. Behind a `}` an
  // end of a statement says nothing, but only where a statement may end at all.
  void choose_breaks() {
    const std::vector<bool> needed = ends_behind(tokens_);
    for (std::size_t i = 1; i < tokens_.size(); ++i) {
      if (!needed[i - 1]) tokens_[i].line_break_before = below(4) == 0;
    }
    for (bool changed = true; changed;) {  // where one statement ends decides about later ones
      changed = false;
      const std::vector<bool> now = ends_behind(tokens_);
      for (std::size_t i = 1; i < tokens_.size(); ++i) {
        if (!now[i - 1] || needed[i - 1] || !tokens_[i].line_break_before) continue;
        tokens_[i].line_break_before = false;
        changed = true;
      }
    }
  }

  // For each token whether an end of a statement is inserted behind it.
  static std::vector<bool> ends_behind(const Tokens& tokens) {
    std::vector<bool> out;
    for (const Token& token : insert_line_ends(tokens)) {
      if (token.inserted) {
        out.back() = true;
      } else {
        out.push_back(false);
      }
    }
    return out;
  }

  void gap(std::string& out, bool has_break) {
    const bool first = out.empty();
    if (!first) out += below(6) == 0 ? "  \t" : " ";
    if (below(12) == 0) out += "/* " + fresh() + " */ ";
    if (!has_break) return;
    if (below(6) == 0)
      out += (below(4) == 0 ? "/// " : "// ") + fresh() + (below(3) == 0 ? "  " : "");
    out += below(8) == 0 ? "\n\n\n" : "\n";
    for (std::size_t i = below(8); i-- > 5;) out += "  // " + fresh() + "\n";
    if (below(15) == 0) out += "/* " + fresh() + "\n   more */" + (below(2) == 0 ? "\n" : " ");
    out.append(below(7), ' ');
  }

  std::string fresh() { return "c" + std::to_string(++comments_); }

  Source source_;
  std::mt19937 random_;
  Tokens tokens_;
  int comments_ = 0;
};

}  // namespace

struct SentenceWriter::State {
  Writer writer;
};

SentenceWriter::SentenceWriter(unsigned seed) : state_(new State{Writer(seed)}) {}
SentenceWriter::~SentenceWriter() = default;
Tokens SentenceWriter::program() { return state_->writer.program(); }
std::string SentenceWriter::text(const Tokens& tokens) { return state_->writer.text(tokens); }
std::size_t SentenceWriter::rules() const { return state_->writer.rules(); }

std::string roughened(const std::string& text, unsigned seed) {
  return Roughener(text, seed).run();
}

TEST_CASE("a sentence is read as the tokens it was made of") {
  SentenceWriter writer(3);
  for (int i = 0; i < 200; ++i) {
    const Tokens program = writer.program();
    const Source source("sentence.rbt", writer.text(program));
    DiagnosticSink sink;
    const Lexed lexed = lex(source, program_range(source), sink, {});
    INFO(source.text());
    REQUIRE(lexed.ok);
    REQUIRE(lexed.tokens.size() == program.size());
    for (std::size_t t = 0; t < program.size(); ++t) CHECK(lexed.tokens[t].type == program[t].type);
  }
}

}  // namespace armlet::lang
