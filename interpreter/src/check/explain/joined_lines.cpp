#include "check/explain/joined_lines.hpp"

namespace armlet::lang {

Joined joined_line(const Checker& checker, const ast::Expr& expr) {
  const ast::Expr* value = nullptr;
  if (expr.kind == ast::ExprKind::kCall) value = expr.as<ast::CallExpr>().callee;
  if (expr.kind == ast::ExprKind::kIndex) value = expr.as<ast::IndexExpr>().object;
  if (value == nullptr) return {};
  const std::string_view behind = (*checker.into.sources)[expr.span.source].slice(
      {value->span.end, expr.span.end, expr.span.source});
  const std::size_t bracket = behind.find_first_not_of(" \t\r\n");
  if (bracket == std::string_view::npos || (behind[bracket] != '(' && behind[bracket] != '[') ||
      behind.substr(0, bracket).find('\n') == std::string_view::npos)
    return {};
  const auto begin = value->span.end + static_cast<std::uint32_t>(bracket);
  return {value->span, {begin, begin + 1, expr.span.source}};
}

void tell_of_joined_lines(const std::vector<Joined>& joined, Diagnostic& diagnostic) {
  if (joined.empty() || diagnostic.fix) return;
  const auto& [value, bracket] = joined.back();
  const Span mark = diagnostic.mark.span;
  if (mark.source != value.source || mark.begin < value.begin || mark.begin > bracket.begin) return;
  diagnostic.related.push_back({bracket, "this goes on with the value of the line above"});
  const Span end{value.end, value.end, value.source};
  diagnostic.fix = Fix{.text = "end the line above with ; if a new statement is meant",
                       .edits = {{end, ";"}},
                       .confidence = Confidence::kMaybe};
}

}  // namespace armlet::lang
