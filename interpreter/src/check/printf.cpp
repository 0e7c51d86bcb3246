#include "check/printf.hpp"

#include <algorithm>

namespace armlet::lang {
namespace {

// %[.digits]letter; letter is 0 where the text cannot be read.
struct Conversion {
  int digits = -1;
  char letter = 0;
  std::size_t size = 0;  // characters after the %
};

Conversion read_conversion(std::string_view text) {
  Conversion out;
  std::size_t at = 0;
  if (at < text.size() && text[at] == '.') {
    out.digits = 0;
    for (++at; at < text.size() && text[at] >= '0' && text[at] <= '9' && out.digits < 100; ++at)
      out.digits = out.digits * 10 + (text[at] - '0');
  }
  constexpr std::string_view kLetters = "dsbfegn%";
  if (at < text.size() && kLetters.find(text[at]) != std::string_view::npos && out.digits < 100)
    out.letter = text[at];
  out.size = at + 1;
  return out;
}

hir::Expr* convert_value(Checker& checker, const ast::Arg& arg, const Conversion& conversion,
                         int position) {
  if (conversion.letter == 's' || conversion.letter == 'b')
    return checker.to_text(checker.check_value(*arg.value));
  if (conversion.letter == 'd') {
    return checker.to_text(checker.check_as(*arg.value, {.role = Target::Role::kArgument,
                                                         .type = checker.types_.integer(),
                                                         .function = "printf",
                                                         .position = position}));
  }
  constexpr int kJavaDigits = 6;
  ast::FormatPiece piece{arg.value, {}};
  piece.format.digits = conversion.digits < 0 ? kJavaDigits : conversion.digits;
  piece.format.style = conversion.letter;
  return checker.formatted_piece(piece);
}

void refuse(Checker& checker, Span span, std::string reason) {
  checker.report(make_diagnostic("E0107", span, {std::move(reason)}));
}

}  // namespace

std::optional<std::vector<hir::Expr*>> printf_parts(Checker& checker, const ast::CallExpr& call) {
  if (call.args.empty() || call.args[0].value->kind != ast::ExprKind::kText) {
    refuse(checker, call.args.empty() ? call.span : call.args[0].span,
           "printf needs its text written here");
    return std::nullopt;
  }
  const Span span = call.args[0].span;
  std::string_view text = call.args[0].value->as<ast::TextExpr>().value;
  std::vector<hir::Expr*> parts;
  const auto add = [&](std::string_view piece) {
    if (piece.empty()) return;
    parts.push_back(checker.make<hir::TextExpr>(hir::ExprKind::kText, checker.types_.text(), span,
                                                checker.arena_.copy(piece)));
  };
  std::size_t used = 1;
  while (!text.empty()) {
    const std::size_t percent = std::min(text.find('%'), text.size());
    add(text.substr(0, percent));
    text.remove_prefix(percent);
    if (text.empty()) break;
    const Conversion conversion = read_conversion(text.substr(1));
    if (conversion.letter == 0) {
      refuse(checker, span, "after % comes d, s, b, f, .2f, e, g, n or %");
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
