#include "syntax/lex.hpp"

#include <algorithm>
#include <optional>

#include "compile/cancelled.hpp"
#include "syntax/lexical_errors.hpp"
#include "syntax/token_kinds.hpp"

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

// Bytes of the character at `at`; 0 if it is not UTF-8, or a control character that no text holds.
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

// The letters of the text; a comment or a text can be as long as the program.
class Letters : public antlr4::ANTLRInputStream {
 public:
  Letters(std::string_view text, const std::atomic<bool>* cancelled)
      : ANTLRInputStream(text.data(), text.size()), cancelled_(cancelled) {}
  void consume() override {
    stop_if(cancelled_);
    ANTLRInputStream::consume();
  }

 private:
  const std::atomic<bool>* cancelled_;
};

// Runs the generated lexer over one part of a text.
class Reader {
 public:
  Reader(const Source& source, Span range, DiagnosticSink& sink, const ParseLimits& limits,
         const std::atomic<bool>* cancelled)
      : source_(source),
        sink_(sink),
        limits_(limits),
        text_(source.slice(range)),
        base_(range.begin),
        stream_(text_, cancelled),
        lexer_(&stream_) {
    lexer_.removeErrorListeners();
    out_.tokens.reserve(text_.size() / 3 + 2);
  }

  Lexed run() {
    while (!finished_) take(*lexer_.nextToken());
    if (out_.tokens.empty() || out_.tokens.back().type != kEndOfText) {
      const auto end = base_ + static_cast<std::uint32_t>(text_.size());
      out_.tokens.push_back(
          {.begin = end, .end = end, .type = kEndOfText, .line_break_before = true});
    }
    return std::move(out_);
  }

 private:
  void take(const antlr4::Token& read) {
    if (read.getChannel() != antlr4::Token::DEFAULT_CHANNEL) return take_hidden(read);
    Token token{.type = static_cast<std::uint16_t>(read.getType()),
                .line_break_before = line_break_};
    line_break_ = false;
    const bool at_end = token.type == kEndOfText;
    token.begin =
        at_end ? base_ + static_cast<std::uint32_t>(text_.size()) : byte_of(read.getStartIndex());
    token.end = at_end ? token.begin : byte_of(read.getStopIndex() + 1);
    finished_ = at_end;
    if (!at_end) check(token);
    out_.tokens.push_back(token);
  }

  void take_hidden(const antlr4::Token& read) {
    if (read.getType() == RbtLexer::NL) {
      line_break_ = true;
      line_failed_ = false;
      return;
    }
    const std::uint32_t begin = byte_of(read.getStartIndex());
    out_.comments.push_back({begin, byte_of(read.getStopIndex() + 1), source_.id()});
  }

  // The lexer counts characters; tokens come in order, so a cursor is enough.
  std::uint32_t byte_of(std::size_t character) {
    while (at_character_ < character) {
      at_byte_ += sequence_length(static_cast<unsigned char>(text_[at_byte_]));
      ++at_character_;
    }
    return base_ + static_cast<std::uint32_t>(at_byte_);
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

  // A closed comment would have been one token, so `/` directly before `*` opens one that is never
  // closed.
  bool opens_comment(const Token& star) const {
    return !out_.tokens.empty() && out_.tokens.back().type == RbtLexer::SLASH &&
           out_.tokens.back().end == star.begin;
  }

  // One message per line: what follows on it is seldom a mistake of its own.
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
  std::string_view text_;
  std::uint32_t base_;
  Letters stream_;
  RbtLexer lexer_;
  Lexed out_;
  std::size_t at_character_ = 0;
  std::size_t at_byte_ = 0;
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

Span program_range(const Source& source) {
  const std::string_view text = source.text();
  std::size_t begin = 0;  // ANTLR drops a mark at the start by itself, and its offsets then differ
  while (text.substr(begin).starts_with(kByteOrderMark)) begin += kByteOrderMark.size();
  if (text.substr(begin).starts_with("#!")) begin = std::min(text.find('\n', begin), text.size());
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(text.size()), source.id()};
}

Lexed lex(const Source& source, Span range, DiagnosticSink& sink, const ParseLimits& limits,
          const std::atomic<bool>* cancelled) {
  return Reader(source, range, sink, limits, cancelled).run();
}

}  // namespace armlet::lang
