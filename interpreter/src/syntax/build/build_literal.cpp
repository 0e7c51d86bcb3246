// Builds numbers and texts.

#include <cctype>
#include <charconv>
#include <cmath>

#include "base/quotes.hpp"
#include "syntax/build/build_ast.hpp"
#include "syntax/build/text_lines.hpp"

namespace armlet::lang {
namespace {

ast::Expr base(ast::ExprKind kind, Span span) { return {.kind = kind, .span = span}; }

// One code point as UTF-8.
void append_utf8(std::string& out, std::uint32_t code) {
  const auto byte = [&](std::uint32_t value) { out += static_cast<char>(value); };
  if (code < 0x80) return byte(code);
  if (code < 0x800) {
    byte(0xC0 | (code >> 6));
  } else {
    byte(0xE0 | (code >> 12));
    byte(0x80 | ((code >> 6) & 0x3F));
  }
  byte(0x80 | (code & 0x3F));
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }

// The position of a mark outside of brackets and inner texts; the end of `text` if there is none.
std::size_t find_mark(std::string_view text, char mark) {
  std::size_t depth = 0;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '\'' || c == '"') {
      quote = c;
    } else if (c == '(' || c == '[' || c == '{') {
      ++depth;
    } else if (c == ')' || c == ']' || c == '}') {
      --depth;
    } else if (c == mark && depth == 0) {
      return i;
    }
  }
  return text.size();
}

// The `}` that closes the brace before `at`, or npos.
std::size_t find_closing(std::string_view text, std::size_t at) {
  std::size_t depth = 1;
  char quote = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '\'' || c == '"') {
      quote = c;
    } else if (c == '{') {
      ++depth;
    } else if (c == '}' && --depth == 0) {
      return at;
    }
  }
  return std::string_view::npos;
}

}  // namespace

ast::Expr* AstBuilder::literal(RbtParser::LiteralContext* ctx) {
  const Span span = token_span(ctx->start);
  switch (ctx->start->getType()) {
    case RbtParser::INT:
      return whole_number(span);
    case RbtParser::FLOAT:
      return real_number(span);
    case RbtParser::QUANTITY:
      return quantity(span);
    case RbtParser::FSTRING:
      return formatted(span);
    case RbtParser::STRING:
      return in_.arena.make<ast::TextExpr>(base(ast::ExprKind::kText, span), decoded(span));
  }
  return in_.arena.make<ast::BoolExpr>(base(ast::ExprKind::kBool, span),
                                       ctx->start->getType() == RbtParser::TRUE);
}

ast::Expr* AstBuilder::whole_number(Span span) {
  std::string digits;
  for (const char c : text(span)) {
    if (c != '_' && c != 'l' && c != 'L') digits += c;
  }
  const bool hexadecimal = digits.size() > 2 && (digits[1] == 'x' || digits[1] == 'X');
  std::int64_t value = 0;
  const std::string_view number = std::string_view(digits).substr(hexadecimal ? 2 : 0);
  const auto read =
      std::from_chars(number.data(), number.data() + number.size(), value, hexadecimal ? 16 : 10);
  const bool too_large = read.ec != std::errc{};
  if (too_large) report(make_diagnostic("E0109", span, {std::string(text(span))}));
  constexpr std::int64_t kFirstOfTwoDigits = 8;  // up to this number octal and decimal are the same
  if (digits[0] == '0' && !hexadecimal && value >= kFirstOfTwoDigits) {
    Diagnostic advice =
        make_diagnostic("W0717", span, {std::string(text(span)), std::to_string(value)});
    advice.fix = Fix{"write " + std::to_string(value), {{span, std::to_string(value)}}};
    report(std::move(advice));
  }
  return in_.arena.make<ast::IntExpr>(base(ast::ExprKind::kInt, span), too_large ? 0 : value,
                                      too_large);
}

ast::Expr* AstBuilder::real_number(Span span) {
  const double value = parse_number(text(span)).value_or(HUGE_VAL);
  if (!std::isfinite(value)) report(make_diagnostic("E0109", span, {std::string(text(span))}));
  return in_.arena.make<ast::RealExpr>(base(ast::ExprKind::kReal, span), value);
}

ast::Expr* AstBuilder::quantity(Span span) {
  const std::optional<Quantity> read = parse_quantity(text(span));
  if (!read || !std::isfinite(read->si)) {
    report(make_diagnostic("E0109", span, {std::string(text(span))}));
    return in_.arena.make<ast::RealExpr>(base(ast::ExprKind::kReal, span), 0.0);
  }
  return in_.arena.make<ast::QuantityExpr>(base(ast::ExprKind::kQuantity, span), read->si,
                                           read->dim, read->number, in_.arena.copy(read->unit));
}

namespace {

Span span_inside_quotes(std::string_view written, Span span) {
  const Quotes quotes = quotes_of(written);
  return {span.begin + static_cast<std::uint32_t>(quotes.opening),
          span.end - static_cast<std::uint32_t>(quotes.closing), span.source};
}

// The lines of the text between the quotes of `written`. A text of one line is unchanged.
TextLines lines_between_quotes(std::string_view written, std::string_view raw) {
  return quotes_of(written).spans_lines ? lines_of_text(raw) : TextLines{.end = raw.size()};
}

}  // namespace

// The characters of a text literal: without quotes and common indentation, with escapes decoded.
std::string_view AstBuilder::decoded(Span literal) {
  const Span inner = span_inside_quotes(text(literal), literal);
  const std::string_view raw = text(inner);
  if (raw.find_first_of("\\\r\n") == std::string_view::npos) return raw;
  const TextLines lines = lines_between_quotes(text(literal), raw);
  std::string out;
  for (std::size_t at = lines.begin; at < lines.end;) {
    if (const std::size_t line_break = line_break_at(raw, at); line_break > 0) {
      out += '\n';
      at = lines.line_start(raw, at + line_break);
    } else if (raw[at] == '\\') {
      at = decode_escape(inner, at, out);
    } else {
      out += raw[at++];
    }
  }
  return in_.arena.copy(out);
}

// Decodes the escape at `at` of the text `span`. Returns the position after it.
std::size_t AstBuilder::decode_escape(Span span, std::size_t at, std::string& out) {
  const std::string_view raw = text(span);
  constexpr std::string_view kLetters = "ntr\\\"'0";
  constexpr std::string_view kMeanings{"\n\t\r\\\"'\0", 7};
  std::size_t length = 2;
  if (const std::size_t known = kLetters.find(raw[at + 1]); known != std::string_view::npos) {
    out += kMeanings[known];
    return at + length;
  }
  if (raw[at + 1] == 'u') {
    const std::string_view digits = raw.substr(at + 2, 4);
    std::uint32_t code = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    const bool whole = digits.size() == 4 && read.ptr == digits.data() + 4;
    if (whole && (code < 0xD800 || code > 0xDFFF)) {
      append_utf8(out, code);
      return at + 6;
    }
    length = 2 + static_cast<std::size_t>(read.ptr - digits.data());
  }
  while (at + length < raw.size() && (raw[at + length] & 0xC0) == 0x80) ++length;
  const auto begin = span.begin + static_cast<std::uint32_t>(at);
  Diagnostic message =
      make_diagnostic("E0105", {begin, begin + static_cast<std::uint32_t>(length), span.source},
                      {std::string(raw.substr(at, length))});
  message.fix = Fix{"for a backslash itself write two",
                    {{{begin, begin, span.source}, "\\"}},
                    Confidence::kMaybe};
  report(std::move(message));
  return at + length;
}

ast::Expr* AstBuilder::formatted(Span span) {
  const Span inner = span_inside_quotes(text(span), span);
  const std::string_view raw = text(inner);
  const TextLines lines = lines_between_quotes(text(span), raw);
  std::vector<std::string_view> texts;
  std::vector<ast::FormatPiece> pieces;
  std::string run;
  const auto at_span = [&](std::size_t from, std::size_t to) {
    return Span{inner.begin + static_cast<std::uint32_t>(from),
                inner.begin + static_cast<std::uint32_t>(to), inner.source};
  };
  for (std::size_t at = lines.begin; at < lines.end;) {
    const char c = raw[at];
    if (const std::size_t line_break = line_break_at(raw, at); line_break > 0) {
      run += '\n';
      at = lines.line_start(raw, at + line_break);
    } else if (c == '\\') {
      at = decode_escape(inner, at, run);
    } else if ((c == '{' || c == '}') && at + 1 < raw.size() && raw[at + 1] == c) {
      run += c;
      at += 2;
    } else if (c == '{') {
      const std::size_t close = find_closing(raw, at + 1);
      if (close == std::string_view::npos) {
        report(make_diagnostic("E0107", at_span(at, at + 1), {"this `{` is never closed"}));
        break;
      }
      texts.push_back(in_.arena.copy(run));
      run.clear();
      pieces.push_back(format_piece(at_span(at + 1, close)));
      at = close + 1;
    } else if (c == '}') {
      report(make_diagnostic("E0107", at_span(at, at + 1), {"this `}` closes nothing"}));
      break;
    } else {
      run += c;
      ++at;
    }
  }
  texts.push_back(in_.arena.copy(run));
  return in_.arena.make<ast::FormattedExpr>(base(ast::ExprKind::kFormatted, span),
                                            in_.arena.copy(texts), in_.arena.copy(pieces));
}

// The contents of a pair of braces in a formatted text: a value, and a format after a colon.
ast::FormatPiece AstBuilder::format_piece(Span piece) {
  const std::string_view raw = text(piece);
  const std::size_t colon = find_mark(raw, ':');  // of the format
  ast::FormatPiece out{};
  Span value = piece;
  value.end = piece.begin + static_cast<std::uint32_t>(colon);
  if (text(value).find_first_not_of(" \t") == std::string_view::npos) {
    report(make_diagnostic("E0107", {piece.begin - 1, piece.end + 1, piece.source},
                           {"there is no value between the braces"}));
  } else if (find_mark(text(value), '?') < text(value).size()) {
    Diagnostic message =
        make_diagnostic("E0107", piece, {"`? :` between braces needs parentheses"});
    message.why = "the first `:` begins the format";
    message.fix = Fix{"write {(" + std::string(raw) + ")}",
                      {{{piece.begin, piece.begin, piece.source}, "("},
                       {{piece.end, piece.end, piece.source}, ")"}},
                      Confidence::kMaybe};
    report(std::move(message));
    failed_ = incomplete_ = true;
    return out;
  } else {
    out.value = in_.parse_piece(value, depth_);
  }
  if (out.value == nullptr) failed_ = incomplete_ = true;
  if (colon < raw.size()) out.format = format_spec({value.end + 1, piece.end, piece.source});
  return out;
}

// A format: [<^>][+][0][width][.digits][f|e|g] and a unit; each part is optional.
ast::FormatSpec AstBuilder::format_spec(Span span) {
  ast::FormatSpec out;
  out.span = span;
  const std::string_view raw = text(span);
  std::size_t at = raw.find_first_not_of(" \t");
  if (at == std::string_view::npos) at = raw.size();
  const std::size_t end = raw.find_last_not_of(" \t") + 1;
  bool good = at < end;
  const auto take = [&](std::string_view signs) {
    return at < end && signs.find(raw[at]) != std::string_view::npos ? raw[at++] : '\0';
  };
  // An int below 10,000; -1 if there is none.
  const auto number = [&] {
    const std::size_t first = at;
    while (at < end && is_digit(raw[at])) ++at;
    good = good && at - first <= 4;
    return at == first || !good ? -1 : std::stoi(std::string(raw.substr(first, at - first)));
  };
  TextStyle& style = out.style;
  style.align = take("<^>");
  style.sign = take("+") != 0;
  style.zeros = take("0") != 0;
  const int width = number();
  if (width > 0 && width <= kMostWidth) style.width = static_cast<std::uint16_t>(width);
  good = good && width <= kMostWidth && (style.zeros ? style.align == 0 && width > 0 : true) &&
         (style.align == 0 || width > 0);
  if (take(".") != 0) {
    const int digits = number();
    good = good && digits >= 0 && digits <= 99;
    if (good) style.digits = static_cast<std::int8_t>(digits);
  }
  const bool is_notation = at < end && (raw[at] == 'f' || raw[at] == 'e' || raw[at] == 'g') &&
                           (style.digits >= 0 || style.width > 0 || style.sign || at + 1 == end ||
                            is_blank(raw[at + 1]));
  if (is_notation) style.notation = raw[at++];
  while (at < end && is_blank(raw[at])) ++at;
  out.unit = raw.substr(at, std::max(end, at) - at);
  good = good &&
         (out.unit.empty() || !std::ispunct(static_cast<unsigned char>(out.unit.front()))) &&
         (out.unit.empty() || !is_digit(out.unit.front())) &&
         out.unit.find_first_of(" \t.") == std::string_view::npos;
  if (!good) {
    Diagnostic message =
        make_diagnostic("E0107", span, {'`' + std::string(raw) + "` is not a format"});
    message.why =
        width > kMostWidth
            ? "a width is at most " + std::to_string(kMostWidth) + " characters"
            : "a format is [< ^ >][+][0][width][.digits][f e g] and a unit, such as 8.2f mm";
    report(std::move(message));
    out.unit = {};
    out.style = {};
  }
  return out;
}

}  // namespace armlet::lang
