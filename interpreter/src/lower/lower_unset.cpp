// Compiles checks for list elements that may have no value yet.

#include <algorithm>

#include "lower/values.hpp"
#include "vocabulary/language_functions.hpp"

namespace armlet::lang {

using namespace hir;

bool may_be_unset(const Lowering& in, const Type& element) {
  return in.tables.program().unset.is_element(&element);
}

bool may_hold_unset(const Lowering& in, const Type& type) {
  return in.tables.program().unset.may_be_in(&type);
}

// Whether a step before the last one uses an element that may have no value.
bool leads_through_unset(const Lowering& in, const Place& place) {
  for (std::size_t i = 0; i + 1 < place.steps.size(); ++i) {
    const Step& step = place.steps[i];
    if (!step.is_field && step.map == nullptr && may_be_unset(in, *step.type)) return true;
  }
  return false;
}

// Loads an element that a loop visits; `written` is the expression of the list.
void load_item(Lowering& in, Reg to, Reg list, Reg index, const Type& element,
               const Expr& written) {
  if (!may_be_unset(in, element)) {
    in.code.emit(OpCode::LD, to, list, index);
    return;
  }
  in.code.at(written.span);
  in.code.emit(OpCode::LDSET, to, list, index);
}

// Checks a value that is used as a whole. only_itself: the elements of a list are not checked.
void check_whole(Lowering& in, const Expr& e, Reg value, bool only_itself) {
  if (!may_hold_unset(in, *e.type)) return;
  in.code.at(e.span);
  in.code.push(OpCode::CHECKSET, value.bits, in.code.type(e.type), only_itself ? 1 : 0);
}

// Library functions get lists whose elements all have values, except functions that only return
// their argument.
void check_arguments(Lowering& in, const CallNativeExpr& e, Reg base) {
  const LanguageFunctions* const language = in.tables.program().language;
  if (language != nullptr && (e.function == language->filled || e.function == language->last))
    return;
  for (std::uint32_t i = 0; i < e.arguments.size(); ++i) {
    const bool is_given = e.arguments[i]->kind != ExprKind::kAbsent;
    if (is_given) check_whole(in, *e.arguments[i], base.plus(i));
  }
}

}  // namespace armlet::lang
