// new Bin[3]: a list of structs whose fields all have defaults.

#include "check/types/new_structs.hpp"

#include <algorithm>

#include "armlet/interpreter/work.hpp"
#include "check/calls/calls.hpp"
#include "check/calls/native_calls.hpp"
#include "check/tree/hand_on.hpp"

namespace armlet::lang {
namespace {

// All elements are one object until one of them is changed.
Signal fill(Vm& vm, Slot* args) {
  const std::int64_t size = args[0].i;
  Obj* const value = args[1].o;
  if (size < 0) {
    Failure failure;
    failure.headline = Headline::own(
        "R0613", "the sizes do not fit: a list cannot have " + std::to_string(size) + " values");
    return fail(vm, std::move(failure));
  }
  if (!charge_work(vm, static_cast<std::uint64_t>(size))) return Signal::kFail;
  constexpr std::int64_t kMost = 0x7FFF'FFFF;
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(std::min(size, kMost)), true);
  if (list == nullptr) return Signal::kFail;
  for (std::uint32_t i = 0; i < list->size; ++i) {
    retain(value);
    list->data[i].o = value;
  }
  args[0].o = list;
  return Signal::kDone;
}

}  // namespace

const NativeFunction kFilled = {.name = "new",
                                .signature = "(size: int, value: T) -> T[]",
                                .help = "A list of equal structs.",
                                .example = "struct Bin { n: int = 0 }; print(new Bin[2])",
                                .thunk = &fill};

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
    const NativeFunction* const functions[] = {&kFilled};
    value = call_native(checker, "new", functions, expr.span, expr.span,
                        {Argument{.value = size}, Argument{.value = value}});
  }
  return value;
}

}  // namespace armlet::lang
