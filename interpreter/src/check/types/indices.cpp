#include "check/types/indices.hpp"

#include <algorithm>
#include <cctype>
#include <string>

#include "check/state/constants.hpp"

namespace armlet::lang {
namespace {

// Whether the text is a name, or names joined by points, which can be evaluated twice.
bool is_written_path(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return c == '.' || c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
  });
}

// Whether an index is a number in the text or computed from such numbers. The value of a variable
// may be tested before: `let best = -1; if (best >= 0) print(xs[best])`.
bool is_literal(const hir::Expr& expr) {
  if (expr.kind == hir::ExprKind::kUnary) return is_literal(*expr.as<hir::UnaryExpr>().operand);
  if (expr.kind == hir::ExprKind::kBinary) {
    const auto& node = expr.as<hir::BinaryExpr>();
    return is_literal(*node.left) && is_literal(*node.right);
  }
  return expr.kind == hir::ExprKind::kInt && !expr.type->is(Kind::kAny);
}

void refuse_below_zero(Checker& checker, const ast::Expr& written, std::int64_t value,
                       const Indexed& of) {
  Diagnostic diagnostic = make_diagnostic("E0340", written.span, {std::to_string(value)});
  const std::string object = checker.text_of(of.object);
  if (is_written_path(object)) {
    const std::string from_end = std::to_string(value).substr(1);  // without its sign
    const std::string meant = object + '.' + std::string(of.size) + " - " + from_end;
    diagnostic.fix = Fix{.text = "counted from the end it is " + meant,
                         .edits = {{written.span, meant}},
                         .confidence = Confidence::kMaybe};
  } else {
    diagnostic.fix = Fix{.text = "count from the end with ." + std::string(of.size)};
  }
  checker.report(std::move(diagnostic));
}

}  // namespace

hir::Expr* index_value(Checker& checker, const ast::Expr& expr, const Indexed& of) {
  hir::Expr* value = checker.check_as(expr, {.type = checker.types.integer(), .name = "index"});
  if (of.object.empty() || !is_literal(*value)) return value;
  const auto constant = checker.shared.constants.of(*value);
  if (constant && constant->kind == Constant::Kind::kInt && constant->integer < 0)
    refuse_below_zero(checker, expr, constant->integer, of);
  return value;
}

}  // namespace armlet::lang
