#include "check/explain/divided_remarks.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace armlet::lang {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool is_operator(char c) { return std::string_view("+-*/%").find(c) != std::string_view::npos; }

// Parses a divisor: 2, n, or (n + 1). It must consist of numbers and of variables that are numbers.
class Divisor {
 public:
  Divisor(Checker& checker, std::string_view text) : checker_(checker), text_(text) {}

  bool is_all() { return operand() && at_ == text_.size(); }
  [[nodiscard]] bool is_int() const { return is_int_; }

 private:
  void skip() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }

  bool operand() {
    skip();
    if (at_ >= text_.size() || ++operands_ > kMost) return false;
    if (text_[at_] == '(') {
      ++at_;
      if (!sum()) return false;
      skip();
      return at_ < text_.size() && text_[at_++] == ')';
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && (is_word(text_[at_]) || text_[at_] == '.')) ++at_;
    const std::string_view word = text_.substr(begin, at_ - begin);
    return !word.empty() && (is_digit(word[0]) ? number(word) : variable(word));
  }

  bool sum() {
    if (!operand()) return false;
    for (skip(); at_ < text_.size() && is_operator(text_[at_]); skip()) {
      ++at_;
      if (!operand()) return false;
    }
    return true;
  }

  bool number(std::string_view word) {
    std::size_t points = 0;
    for (const char c : word) {
      if (c == '.' ? ++points > 1 : !is_digit(c)) return false;
    }
    is_int_ = is_int_ && points == 0;
    return true;
  }

  bool variable(std::string_view word) {
    FunctionContext* where = nullptr;
    const Local* local = checker_.scopes.find(word, where);
    if (local == nullptr) return false;
    const Type& type = *local->variable->type;
    is_int_ = is_int_ && type.is(Kind::kInt);
    return type.is(Kind::kInt) || type.is_double();
  }

  static constexpr int kMost = 20;
  Checker& checker_;
  std::string_view text_;
  std::size_t at_ = 0;
  int operands_ = 0;
  bool is_int_ = true;
};

struct Remark {
  Span whole{};             // from the end of the value to the end of the comment's divisor
  std::string_view inside;  // the divisor
};

// The comment directly after a value, with at most one blank on each side of its mark.
Remark remark_behind(std::string_view text, std::uint32_t end, std::uint32_t source) {
  const std::size_t blank = text.substr(end).starts_with(' ') ? 1 : 0;
  if (!text.substr(end + blank).starts_with("//")) return {};
  const std::size_t begin = end + blank + 2;
  std::string_view inside = text.substr(begin, text.find_first_of("\r\n", begin) - begin);
  while (inside.ends_with(' ') || inside.ends_with(';')) inside.remove_suffix(1);
  const auto last = static_cast<std::uint32_t>(begin + inside.size());
  if ((inside.starts_with(' ') ? 1U : 0U) != blank) return {};
  inside.remove_prefix(blank);
  return {{end, last, source}, inside};
}

// The span of an expression with the parentheses around it.
Span with_parentheses(std::string_view text, const ast::Expr& written) {
  Span out = written.span;
  for (int i = 0; i < written.parens; ++i) {
    const std::size_t open = text.substr(0, out.begin).find_last_not_of(" \t");
    const std::size_t close = text.find_first_not_of(" \t", out.end);
    if (open == std::string_view::npos || text[open] != '(' || close == std::string_view::npos ||
        text[close] != ')')
      break;
    out.begin = static_cast<std::uint32_t>(open);
    out.end = static_cast<std::uint32_t>(close + 1);
  }
  return out;
}

// Whether a division sign after the expression would divide all of it.
bool is_divided_whole(const ast::Expr& written) {
  using ast::ExprKind;
  if (written.parens > 0) return true;
  constexpr std::array kWhole = {ExprKind::kInt,    ExprKind::kReal,  ExprKind::kName,
                                 ExprKind::kMember, ExprKind::kIndex, ExprKind::kCall};
  return std::ranges::find(kWhole, written.kind) != kWhole.end();
}

// Whether the comment states the value itself, so that it is not a divisor.
bool is_result(const Checker& checker, const hir::Expr& value, std::string_view divisor) {
  const std::optional<Constant> known = checker.shared.constants.of(value);
  return known && known->kind == Constant::Kind::kInt && std::to_string(known->integer) == divisor;
}

}  // namespace

void advise_on_divided_remark(Checker& checker, const ast::Expr& written, const hir::Expr& value,
                              const Type* type) {
  const bool was_int = value.kind == hir::ExprKind::kConvert &&
                       value.as<hir::ConvertExpr>().conversion == hir::Conversion::kIntToReal;
  const bool is_int = was_int || value.type->is(Kind::kInt);
  if (!is_int && !value.type->is_double()) return;
  const std::string_view text = (*checker.into.sources)[written.span.source].text();
  const Span divided = with_parentheses(text, written);
  const Remark remark = remark_behind(text, divided.end, divided.source);
  if (remark.inside.empty() || is_result(checker, value, remark.inside)) return;
  Divisor divisor(checker, remark.inside);
  if (!divisor.is_all()) return;
  const std::string left = checker.text_of(divided);
  const std::string right(remark.inside);
  Diagnostic advice =
      make_diagnostic("W0718", {divided.end, remark.whole.end, divided.source}, {right, left});
  const bool both_ints = is_int && divisor.is_int();
  const bool becomes_double = type != nullptr && type->is_double();
  const std::string quotient = left + " / " + right;
  const std::string fix = !both_ints       ? "floor(" + quotient + ")"
                          : becomes_double ? "double(" + quotient + ")"
                                           : quotient;
  advice.why = both_ints ? "/ between two ints drops the fraction" : "floor drops the fraction";
  advice.fix = Fix{.text = "write " + fix};
  if (is_divided_whole(written))
    advice.fix->edits = {{{divided.begin, remark.whole.end, divided.source}, fix}};
  checker.report(std::move(advice));
}

}  // namespace armlet::lang
