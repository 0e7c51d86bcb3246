#include "check/library/explained.hpp"

#include "check/library/printf.hpp"

namespace armlet::lang {
namespace {

// Whether two values are reads of the same variable.
bool is_same_variable(Checker& checker, const hir::Expr& a, const hir::Expr& b) {
  if (a.kind == hir::ExprKind::kVariable && b.kind == hir::ExprKind::kVariable)
    return a.as<hir::VariableExpr>().variable == b.as<hir::VariableExpr>().variable;
  return a.kind == b.kind && a.kind != hir::ExprKind::kCallNative &&
         checker.text_of(a.span) == checker.text_of(b.span);
}

}  // namespace

hir::Expr* explained_call(Checker& checker, std::string_view name,
                          const std::vector<Argument>& arguments, Span span) {
  if (name != "explain" || arguments.empty() || arguments.size() > 2) return nullptr;
  const Argument& last = arguments.back();
  if (last.waits() || !last.name.empty() || last.value->kind != hir::ExprKind::kCallNative)
    return nullptr;
  const auto& call = last.value->as<hir::CallNativeExpr>();
  if (!call.function->explain || call.arguments.empty()) return nullptr;
  if (arguments.size() == 2) {
    const Argument& object = arguments.front();
    if (object.waits() || !is_same_variable(checker, *object.value, *call.arguments[0]))
      return nullptr;
  }
  NativeFunction told = *call.function;
  told.thunk = told.explain;
  told.real1 = nullptr;
  told.real2 = nullptr;
  told.real3 = nullptr;
  const auto* function = checker.arena.make<NativeFunction>(told);
  return checker.make<hir::CallNativeExpr>(hir::ExprKind::kCallNative, checker.types.text(), span,
                                           function, call.arguments, call.site);
}

hir::Expr* shown_explanation(Checker& checker, const ast::ExprStmt& stmt, hir::Expr* value) {
  constexpr std::string_view kName = "explain";
  if (stmt.value->kind != ast::ExprKind::kCall || value->kind != hir::ExprKind::kCallNative ||
      !value->type->is(Kind::kText)) {
    return nullptr;
  }
  const auto& call = stmt.value->as<ast::CallExpr>();
  const bool is_method = call.callee->kind == ast::ExprKind::kMember;
  if (is_method ? call.callee->as<ast::MemberExpr>().member.text != kName
                : checker.text_of(call.callee->span) != kName) {
    return nullptr;
  }
  return print_line(checker, call, value);
}

}  // namespace armlet::lang
