#include "check/library/printf.hpp"

#include <algorithm>

#include "check/library/formatted.hpp"

namespace armlet::lang {
namespace {

// A conversion %[-][+][0][width][.digits]letter; the letter is 0 if it is invalid.
struct Conversion {
  TextStyle style;
  char letter = 0;
  std::size_t size = 0;  // characters after the %
};

Conversion read_conversion(std::string_view text) {
  Conversion out;
  std::size_t at = 0;
  const auto number = [&] {
    int value = 0;
    for (; at < text.size() && text[at] >= '0' && text[at] <= '9' && value <= kMostWidth; ++at)
      value = value * 10 + (text[at] - '0');
    return value;
  };
  bool is_left = false;
  for (; at < text.size() && std::string_view("-+0").find(text[at]) != std::string_view::npos;
       ++at) {
    is_left = is_left || text[at] == '-';
    out.style.sign = out.style.sign || text[at] == '+';
    out.style.zeros = out.style.zeros || text[at] == '0';
  }
  const int width = number();
  int digits = -1;
  if (at < text.size() && text[at] == '.') {
    ++at;
    digits = number();
  }
  constexpr std::string_view kLetters = "dsbfegn%";
  constexpr int kMostDigits = 99;
  const bool has_letter = at < text.size() && kLetters.find(text[at]) != std::string_view::npos;
  out.size = at + 1;
  if (!has_letter || width > kMostWidth || digits > kMostDigits) return out;
  out.letter = text[at];
  out.style.width = static_cast<std::uint16_t>(width);
  out.style.digits = static_cast<std::int8_t>(digits);
  // Java pads on the left, texts too.
  out.style.align = width == 0 ? '\0' : is_left ? '<' : '>';
  out.style.zeros = out.style.zeros && !is_left && width > 0;
  return out;
}

hir::Expr* convert_value(Checker& checker, const ast::Arg& arg, const Conversion& conversion,
                         int position) {
  ast::FormatPiece piece{arg.value, {}};
  piece.format.style = conversion.style;
  hir::Expr* value = conversion.letter == 'd'
                         ? checker.check_as(*arg.value, {.role = Target::Role::kArgument,
                                                         .type = checker.types.integer(),
                                                         .function = "printf",
                                                         .position = position})
                         : checker.check_value(*arg.value);
  const bool is_text = conversion.letter == 's' || conversion.letter == 'b';
  if (is_text) {
    piece.format.style.zeros = piece.format.style.sign = false;
    value = to_text(checker, value);
  } else if (conversion.letter != 'd') {
    constexpr int kJavaDigits = 6;
    if (conversion.style.digits < 0) piece.format.style.digits = kJavaDigits;
    piece.format.style.notation = conversion.letter;
  }
  if (is_text || conversion.letter == 'd') piece.format.style.digits = -1;
  return in_format(checker, value, piece.format);
}

void refuse_printf(Checker& checker, Span span, std::string reason) {
  checker.report(make_diagnostic("E0107", span, {std::move(reason)}));
}

}  // namespace

std::optional<std::vector<hir::Expr*>> printf_parts(Checker& checker, const ast::CallExpr& call) {
  if (call.args.empty() || call.args[0].value->kind != ast::ExprKind::kText) {
    refuse_printf(checker, call.args.empty() ? call.span : call.args[0].span,
                  "printf needs its text written here");
    return std::nullopt;
  }
  const Span span = call.args[0].span;
  std::string_view text = call.args[0].value->as<ast::TextExpr>().value;
  std::vector<hir::Expr*> parts;
  const auto add = [&](std::string_view piece) {
    if (piece.empty()) return;
    parts.push_back(checker.make<hir::TextExpr>(hir::ExprKind::kText, checker.types.text(), span,
                                                checker.arena.copy(piece)));
  };
  std::size_t used = 1;
  while (!text.empty()) {
    const std::size_t percent = std::min(text.find('%'), text.size());
    add(text.substr(0, percent));
    text.remove_prefix(percent);
    if (text.empty()) break;
    const Conversion conversion = read_conversion(text.substr(1));
    if (conversion.letter == 0) {
      refuse_printf(checker, span, "after % comes d, s, b, f, .2f, 8.2f, e, g, n or %");
      return std::nullopt;
    }
    text.remove_prefix(1 + conversion.size);
    if (conversion.letter == '%' || conversion.letter == 'n') {
      add(conversion.letter == 'n' ? "\n" : "%");
    } else if (used < call.args.size()) {
      parts.push_back(
          convert_value(checker, call.args[used], conversion, static_cast<int>(used) + 1));
      ++used;
    } else {
      ++used;
    }
  }
  if (used == call.args.size()) return parts;
  const auto count = [](std::size_t n) {
    return std::to_string(n) + (n == 1 ? " value" : " values") + " after this text";
  };
  checker.report(make_diagnostic(
      "E0312", span, {"printf", count(used - 1), std::to_string(call.args.size() - 1)}));
  return std::nullopt;
}

}  // namespace armlet::lang
