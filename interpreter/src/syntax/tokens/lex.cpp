#include "syntax/tokens/lex.hpp"

#include <RbtTables.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "base/cancelled.hpp"
#include "syntax/tokens/lexical_errors.hpp"
#include "syntax/tokens/token_kinds.hpp"

namespace armlet::lang {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::size_t sequence_length(unsigned char first) {
  return first < 0x80   ? 1
         : first < 0xC2 ? 0
         : first < 0xE0 ? 2
         : first < 0xF0 ? 3
         : first < 0xF5 ? 4
                        : 0;
}

// The length of the character at `at`, bytes; 0 if it is not UTF-8, or a control character that
// texts may not contain.
std::size_t character_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  if (first < 0x20) return first == '\n' || first == '\r' || first == '\t' || first == '\f' ? 1 : 0;
  const std::size_t length = sequence_length(first);
  if (length == 0 || at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0) != 0x80) return 0;
  }
  if ((first == 0xE0 && byte(at + 1) < 0xA0) || (first == 0xED && byte(at + 1) > 0x9F) ||
      (first == 0xF0 && byte(at + 1) < 0x90) || (first == 0xF4 && byte(at + 1) > 0x8F)) {
    return 0;
  }
  return length;
}

std::optional<std::size_t> first_bad_byte(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text, at);
    if (length == 0) return at;
    at += length;
  }
  return std::nullopt;
}

// The character at `at` of a valid UTF-8 text.
struct Character {
  std::uint32_t code;
  std::size_t length;  // bytes

  Character(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[at + i]); };
    length = sequence_length(byte(0));
    code = length == 1 ? byte(0) : byte(0) & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) code = code << 6U | (byte(i) & 0x3FU);
  }

  std::size_t of_class() const {
    if (code < std::size(rbt_tables::kAsciiClass)) return rbt_tables::kAsciiClass[code];
    return std::ranges::upper_bound(rbt_tables::kCharacterRanges, code, {},
                                    &rbt_tables::CharacterRange::end)
        ->of_class;
  }
};

// Whether the character at `at` is a letter, digit or _ as in the grammar.
bool continues_word(std::string_view text, std::size_t at) {
  if (at >= text.size()) return false;
  const std::uint32_t c = Character(text, at).code;
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         (c >= 0xC0 && c <= 0x24F && c != 0xD7 && c != 0xF7) || (c >= 0x370 && c <= 0x3FF);
}

struct Piece {
  std::uint16_t type;
  std::size_t end;  // bytes
};

// The longest token at `begin`; of equally long ones the first in the grammar. The automaton is
// that of the generated lexer (grammar/make_tables.cpp).
Piece longest_token(std::string_view text, std::size_t begin, const std::atomic<bool>* cancelled) {
  // Characters between two checks; a comment may be as long as the program.
  constexpr std::size_t kOften = 4096;
  Piece longest{RbtLexer::ERR, begin};
  std::size_t state = 1, since_check = 0;
  for (std::size_t at = begin; at < text.size();) {
    if (++since_check % kOften == 0) stop_if(cancelled);
    const Character character(text, at);
    state =
        rbt_tables::kNextLexerState[state * rbt_tables::kCharacterClasses + character.of_class()];
    if (state == 0) break;
    at += character.length;
    if (rbt_tables::kTokenOfState[state] != 0) longest = {rbt_tables::kTokenOfState[state], at};
  }
  return longest;
}

// `10mm/speed` is `10mm`, `/`, `speed`: a unit that would end inside of a word is shortened, as by
// trimQuantity of the grammar.
Piece trimmed(std::string_view text, std::size_t begin, Piece quantity) {
  const std::size_t whole = quantity.end;
  while (continues_word(text, quantity.end)) {
    do {
      if (quantity.end == begin) {
        quantity = {RbtLexer::BADNUM, whole};
        while (continues_word(text, quantity.end))
          quantity.end += Character(text, quantity.end).length;
        return quantity;
      }
      --quantity.end;
    } while (std::string_view("*/^").find(text[quantity.end]) == std::string_view::npos);
  }
  return quantity;
}

// Whether a keyword of statements may be the name of an argument.
bool names_arguments(std::uint16_t type) {
  return type == RbtLexer::EVERY || type == RbtLexer::WHEN;
}

// The kind of a UTF-8 text that is one token; the kind of an invalid token for other texts.
std::uint16_t token_type(std::string_view text) {
  if (text.empty() || first_bad_byte(text)) return RbtLexer::ERR;
  const Piece piece = longest_token(text, 0, nullptr);
  return piece.end == text.size() ? piece.type : std::uint16_t{RbtLexer::ERR};
}

// Divides one part of a text into tokens.
class Reader {
 public:
  Reader(const Source& source, Span range, DiagnosticSink& sink, const ParseLimits& limits,
         const std::atomic<bool>* cancelled)
      : source_(source),
        sink_(sink),
        limits_(limits),
        cancelled_(cancelled),
        text_(source.slice(range)),
        base_(range.begin) {
    out_.tokens.reserve(text_.size() / 3 + 2);
  }

  Lexed run() {
    for (std::size_t at = 0; at < text_.size() && !finished_;) {
      stop_if(cancelled_);
      Piece piece = longest_token(text_, at, cancelled_);
      if (piece.type == RbtLexer::QUANTITY) piece = trimmed(text_, at, piece);
      take(piece.type, {base_ + static_cast<std::uint32_t>(at),
                        base_ + static_cast<std::uint32_t>(piece.end), source_.id()});
      at = piece.end;
    }
    const auto end = base_ + static_cast<std::uint32_t>(text_.size());
    out_.tokens.push_back({.begin = end,
                           .end = end,
                           .type = kEndOfText,
                           .line_break_before = line_break_ || finished_});
    return std::move(out_);
  }

 private:
  void take(std::uint16_t type, Span span) {
    if (type == RbtLexer::WS) return;
    if (type == RbtLexer::NL) {
      line_break_ = true;
      line_failed_ = false;
      return;
    }
    if (type == RbtLexer::LINE_COMMENT || type == RbtLexer::BLOCK_COMMENT) {
      out_.comments.push_back(span);
      return;
    }
    const Token token{
        .begin = span.begin, .end = span.end, .type = type, .line_break_before = line_break_};
    line_break_ = false;
    if (type == RbtLexer::COLON) name_argument();
    check(token);
    out_.tokens.push_back(token);
  }

  // `every: 1ms` and `when: [...]` in a call: the keyword is the name of an argument.
  void name_argument() {
    const std::size_t count = out_.tokens.size();
    if (count < 2) return;
    const std::uint16_t before = out_.tokens[count - 2].type;
    Token& word = out_.tokens[count - 1];
    const bool opens = before == RbtLexer::LPAREN || before == RbtLexer::COMMA;
    if (opens && names_arguments(word.type)) word.type = RbtLexer::ID;
  }

  void check(const Token& token) {
    const Span span{token.begin, token.end, source_.id()};
    if (is_opener(token.type) && ++depth_ > limits_.nesting) {
      fail(make_diagnostic("E0125", span, {std::to_string(limits_.nesting) + " levels"}));
      finished_ = true;
    } else if (is_closer(token.type) && depth_ > 0) {
      --depth_;
    } else if (token.type == RbtLexer::BADNUM) {
      fail(bad_number(source_, span));
    } else if (token.type == RbtLexer::BADSTR) {
      fail(unclosed_text(source_, span));
    } else if (token.type == RbtLexer::ERR) {
      fail(bad_character(source_, span));
    } else if (token.type == RbtLexer::STAR && opens_comment(token)) {
      fail(unclosed_comment(source_, {token.begin - 1, token.end, span.source}));
      finished_ = true;
    }
    if (out_.tokens.size() >= limits_.tokens) {
      fail(make_diagnostic("E0124", span,
                           {"more than " + std::to_string(limits_.tokens) + " words and signs"}));
      finished_ = true;
    }
  }

  // Whether `/` and the `*` directly after it begin a comment that is not closed; a closed comment
  // would have been one token.
  bool opens_comment(const Token& star) const {
    return !out_.tokens.empty() && out_.tokens.back().type == RbtLexer::SLASH &&
           out_.tokens.back().end == star.begin;
  }

  // Reports at most one message per line, because the rest of a line with an invalid token is
  // seldom a mistake of its own.
  void fail(Diagnostic diagnostic) {
    out_.ok = false;
    if (line_failed_) return;
    line_failed_ = true;
    sink_.begin_statement();
    sink_.report(std::move(diagnostic));
    if (sink_.full()) finished_ = true;
  }

  const Source& source_;
  DiagnosticSink& sink_;
  const ParseLimits& limits_;
  const std::atomic<bool>* cancelled_;
  std::string_view text_;
  std::uint32_t base_;
  Lexed out_;
  std::size_t depth_ = 0;
  bool line_failed_ = false;
  bool line_break_ = false;
  bool finished_ = false;
};

}  // namespace

bool check_text(const Source& source, DiagnosticSink& sink, const ParseLimits& limits) {
  sink.begin_statement();
  const std::string_view text = source.text();
  const Span start{0, 0, source.id()};
  if (text.size() > limits.bytes) {
    sink.report(make_diagnostic(
        "E0124", start,
        {std::to_string(text.size()) + " bytes; the limit is " + std::to_string(limits.bytes)}));
    return false;
  }
  if (const std::optional<std::size_t> bad = first_bad_byte(text)) {
    const int line = source.position(static_cast<std::uint32_t>(*bad)).line;
    Diagnostic out = make_diagnostic("E0123", start);
    out.why = "byte " + std::to_string(*bad + 1) + ", on line " + std::to_string(line) +
              ", is not part of a character";
    out.fix = Fix{"save the program as text with the encoding UTF-8", {}, {}};
    sink.report(std::move(out));
    return false;
  }
  return true;
}

bool is_name(std::string_view text) {
  const std::uint16_t type = token_type(text);
  return type == RbtLexer::ID || word_of(type).kind == WordKind::kSoft;
}

bool is_argument_name(std::string_view text) {
  return is_name(text) || names_arguments(token_type(text));
}

Span program_range(const Source& source) {
  const std::string_view text = source.text();
  std::size_t begin = 0;
  while (text.substr(begin).starts_with(kByteOrderMark)) begin += kByteOrderMark.size();
  if (text.substr(begin).starts_with("#!")) begin = std::min(text.find('\n', begin), text.size());
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(text.size()), source.id()};
}

Lexed lex(const Source& source, Span range, DiagnosticSink& sink, const ParseLimits& limits,
          const std::atomic<bool>* cancelled) {
  return Reader(source, range, sink, limits, cancelled).run();
}

}  // namespace armlet::lang
