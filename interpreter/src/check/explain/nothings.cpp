#include "check/explain/nothings.hpp"

#include <algorithm>
#include <array>

namespace armlet::lang {
namespace {

struct Question {
  std::string why;
  std::string text;  // that replaces the comparison; empty: there is none
};

// The test for a value of this type that corresponds to "is missing" in other languages.
Question question_about(Checker& checker, const hir::Expr& other, bool equal) {
  const Type& type = *other.type;
  const std::string value = checker.text_of(other.span);
  const std::string sign = equal ? " == " : " != ";
  if (other.kind == hir::ExprKind::kEntry) {
    const auto& entry = other.as<hir::EntryExpr>();
    const std::string has =
        checker.text_of(entry.object->span) + ".has(" + checker.text_of(entry.key->span) + ")";
    return {"a key that is not there is an error; has asks for it", (equal ? "!" : "") + has};
  }
  if (type.is(Kind::kText))
    return {"a text is always there; it may be empty", value + sign + "\"\""};
  if (type.is(Kind::kList) || type.is(Kind::kMap)) {
    const std::string what = type.is(Kind::kList) ? "a list" : "a map";
    return {what + " is always there; it may be empty", value + ".length" + sign + "0"};
  }
  return {type_phrase(&type) +
              " is always there: where there may be none, keep a list, which may be " +
              "empty, or a bool beside it",
          ""};
}

}  // namespace

bool is_nothing(std::string_view name) {
  constexpr std::array<std::string_view, 6> kNothings = {"null", "None",      "nil",
                                                         "NULL", "undefined", "nullptr"};
  return std::ranges::find(kNothings, name) != kNothings.end();
}

const ast::Expr* nothing_in(Checker& checker, const ast::BinaryExpr& comparison) {
  if (comparison.op != ast::BinaryOp::kEq && comparison.op != ast::BinaryOp::kNe) return nullptr;
  for (const ast::Expr* side : {comparison.left, comparison.right}) {
    if (side->kind != ast::ExprKind::kName) continue;
    const std::string_view name = side->as<ast::NameExpr>().name;
    FunctionContext* where = nullptr;
    if (is_nothing(name) && checker.scopes.find(name, where) == nullptr) return side;
  }
  return nullptr;
}

hir::Expr* compared_with_nothing(Checker& checker, const ast::BinaryExpr& comparison,
                                 const ast::Expr& nothing, const hir::Expr& other) {
  if (other.type->is(Kind::kAny) || checker.messages.syntax_failed())
    return checker.failed(comparison.span);
  const std::string name(nothing.as<ast::NameExpr>().name);
  const bool equal = comparison.op == ast::BinaryOp::kEq;
  const Question question = question_about(checker, other, equal);
  Diagnostic diagnostic = make_diagnostic("E0310", nothing.span, {name});
  diagnostic.why = question.why;
  const bool is_plain = comparison.left->parens == 0 && comparison.right->parens == 0;
  if (!question.text.empty() && is_plain) {
    diagnostic.fix = Fix{.text = "write " + question.text,
                         .edits = {{comparison.span, question.text}},
                         .confidence = Confidence::kMaybe};
  }
  checker.report(std::move(diagnostic));
  return checker.failed(comparison.span);
}

}  // namespace armlet::lang
