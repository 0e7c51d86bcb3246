// new Bin[3]: lists of structs whose fields all have defaults.

#include "check/expressions/new_structs.hpp"

#include <algorithm>

#include "check/calls/calls.hpp"
#include "check/library/native_calls.hpp"

namespace armlet::lang {
namespace {

bool has_all_defaults(const ast::StructStmt& node) {
  return std::ranges::all_of(
      node.fields, [](const ast::Param& field) { return field.default_value != nullptr; });
}

}  // namespace

hir::Expr* new_structs(Checker& checker, const ast::NewArrayExpr& expr, const Type* type) {
  const StructDecl* const known = checker.shared.structs.find(type);
  if (known == nullptr || !has_all_defaults(*known->node)) return nullptr;
  hir::Expr* value = construct(checker, *known, expr.element->span, expr.span, {});
  for (std::size_t i = expr.sizes.size(); i-- > 0;) {
    if (value->type->is(Kind::kAny)) return checker.failed(expr.span);
    hir::Expr* size =
        checker.check_as(*expr.sizes[i], {.type = checker.types.integer(), .name = "size"});
    const NativeFunction* const functions[] = {checker.registry.language().filled};
    value = call_native(checker, "new", functions, expr.span, expr.span,
                        {Argument{.value = size}, Argument{.value = value}});
  }
  return value;
}

}  // namespace armlet::lang
