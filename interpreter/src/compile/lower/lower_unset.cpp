// Elements that may have no value yet: what reads them looks first.

#include <algorithm>

#include "check/tree/hand_on.hpp"
#include "compile/lower/lowering.hpp"

namespace armlet::lang {

using namespace hir;

bool Lowering::may_be_unset(const Type& element) const {
  return tables_.program().unset.is_element(&element);
}

bool Lowering::may_hold_unset(const Type& type) const {
  return tables_.program().unset.may_be_in(&type);
}

// Whether a step before the last one goes through an element that may be not set.
bool Lowering::leads_through_unset(const Place& place) const {
  for (std::size_t i = 0; i + 1 < place.steps.size(); ++i) {
    const Step& step = place.steps[i];
    if (!step.is_field && step.map == nullptr && may_be_unset(*step.type)) return true;
  }
  return false;
}

// An element that a loop visits; `written` is the list.
void Lowering::load_item(Reg to, Reg list, Reg index, const Type& element, const Expr& written) {
  if (!may_be_unset(element)) {
    code_.emit(OpCode::LD, to, list, index);
    return;
  }
  code_.at(written.span);
  code_.emit(OpCode::LDSET, to, list, index);
}

// A value that is used as a whole. only_itself: what lies in the elements of a list is not read.
void Lowering::check_whole(const Expr& e, Reg value, bool only_itself) {
  if (!may_hold_unset(*e.type)) return;
  code_.at(e.span);
  code_.push(OpCode::CHECKSET, value.bits, code_.type(e.type), only_itself ? 1 : 0);
}

// Functions of the library find all elements set, unless they only hand on what they are given.
void Lowering::check_arguments(const CallNativeExpr& e, Reg base) {
  if (e.function == &kFilled || e.function == &kLast) return;
  for (std::uint32_t i = 0; i < e.arguments.size(); ++i) {
    const bool is_given = e.arguments[i]->kind != ExprKind::kAbsent;
    if (is_given) check_whole(*e.arguments[i], base.plus(i));
  }
}

}  // namespace armlet::lang
