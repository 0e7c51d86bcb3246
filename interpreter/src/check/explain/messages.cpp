#include "check/state/messages.hpp"

#include <utility>

#include "check/explain/file_names.hpp"
#include "check/explain/joined_lines.hpp"
#include "check/state/checker.hpp"

namespace armlet::lang {

void Messages::report(Diagnostic diagnostic) {
  const FunctionContext& root = scopes_.here().root();
  const bool is_error = diagnostic.severity == Severity::kError;
  if (is_error && root.instance != nullptr && root.declaration->is_generic()) {
    std::string types;
    for (const Type* type : root.instance->types)
      types += (types.empty() ? "" : " and ") + type_phrase(type);
    diagnostic.related.push_back({root.instance->first_call, "called here with " + types});
  }
  if (is_error) {
    tell_of_joined_lines(joined_, diagnostic);
    ++errors_;
  }
  sink_.report(std::move(diagnostic));
}

hir::Expr* Checker::failed(Span span) {
  return make<hir::IntExpr>(hir::ExprKind::kInt, types.any(), span, std::int64_t{0});
}

hir::Expr* Checker::guessed(Span span, const Type* type) {
  if (!shared.guesses || type == nullptr) return failed(span);
  return make<hir::AbsentExpr>(hir::ExprKind::kAbsent, type, span);
}

std::string Checker::text_of(Span span) const { return std::string(into.sources->slice(span)); }

int Checker::line_of(Span span) const { return into.sources->position(span).line; }

// The name of a function without a name, by its line, for messages at run time.
std::string line_name(const Checker& checker, Span span) {
  const std::string line = "line " + std::to_string(checker.line_of(span));
  return is_main_file(checker) ? line : line + " of " + file_name(checker);
}

}  // namespace armlet::lang
