#include "check/any_table.hpp"

namespace armlet::lang {

bool is_any_table(const Checker& checker, const ast::TypeExpr* type) {
  return type != nullptr && type->form == ast::TypeForm::kNamed && type->path.size() == 1 &&
         type->path[0].text == "table" && !checker.named_types_.contains("table");
}

const Type* resolve_open(Checker& checker, const ast::TypeExpr* type) {
  return type == nullptr || is_any_table(checker, type) ? nullptr : checker.resolve(*type);
}

hir::Expr* require_table(Checker& checker, const ast::TypeExpr* type, hir::Expr* value) {
  if (!is_any_table(checker, type) || value->type->is_table() || value->type->is(Kind::kAny)) {
    return value;
  }
  checker.report(make_diagnostic("E0315", value->span, {"a table", type_phrase(value->type)}));
  return checker.failed(value->span);
}

}  // namespace armlet::lang
