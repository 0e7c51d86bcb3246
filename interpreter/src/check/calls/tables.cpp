#include "check/calls/tables.hpp"

#include "check/calls/fields.hpp"
#include "check/functions/functions.hpp"

namespace armlet::lang {

hir::Expr* builtin(Checker& checker, const NativeFunction& function, const Type* type, Span span,
                   std::vector<hir::Expr*> arguments) {
  std::vector<Span> spans;
  for (const hir::Expr* argument : arguments) spans.push_back(argument->span);
  return checker.make<hir::CallNativeExpr>(hir::ExprKind::kCallNative, type, span, &function,
                                           checker.seq(arguments),
                                           hir::CallSite{span, span, checker.seq(spans)});
}

hir::Expr* column_of(Checker& checker, hir::Expr* table, const ast::MemberExpr& member) {
  if (member.member.text == "length")
    return builtin(checker, *checker.registry.language().table_length, checker.types.integer(),
                   member.span, {table});
  if (!settle(checker, *table)) return checker.failed(member.span);
  const RecordInfo& info = *table->type->record;
  const int column = checker.shared.structs.field_index(info, member.member.text);
  if (column < 0) return unknown_field(checker, *table, member.member);
  hir::Expr* number = checker.make<hir::IntExpr>(hir::ExprKind::kInt, checker.types.integer(),
                                                 member.span, static_cast<std::int64_t>(column));
  return builtin(checker, *checker.registry.language().table_column, info.fields[column].type,
                 member.span, {table, number});
}

hir::Expr* rows_of(Checker& checker, hir::Expr* table) {
  if (!settle(checker, *table)) return checker.failed(table->span);
  return builtin(checker, *checker.registry.language().table_rows,
                 checker.types.list(table->type->record->row), table->span, {table});
}

}  // namespace armlet::lang
