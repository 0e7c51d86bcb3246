// Expressions whose value is an object: texts, lists, records, closures, values of the host.

#include <algorithm>
#include <stdexcept>

#include "compile/lower/lowering.hpp"

namespace armlet::lang {

using namespace hir;

namespace {

// print(x) of a text is the text.
bool is_text_already(const ToTextExpr& e) {
  return e.value->type->is(Kind::kText) && e.style.is_plain() && e.unit.empty();
}

// m.get(k, other)
bool gives_other(const Expr& e) {
  return e.kind == ExprKind::kEntry && e.as<EntryExpr>().otherwise != nullptr;
}

// What the program, or a list or record that somebody else keeps, holds already.
bool belongs_to_other(const Expr& e) {
  return !gives_other(e) && is_one_of(e.kind, {ExprKind::kText, ExprKind::kAbsent, ExprKind::kField,
                                               ExprKind::kEntry, ExprKind::kElement});
}

// A text that is known.
bool constant_text(const Expr& e, std::string_view& out) {
  if (e.kind == ExprKind::kText) {
    out = e.as<TextExpr>().value;
    return true;
  }
  if (e.constant == nullptr || e.constant->kind != Constant::Kind::kText) return false;
  out = e.constant->text;
  return e.type->is(Kind::kText);
}

}  // namespace

Hold stronger(Hold a, Hold b) { return std::max(a, b); }

Hold hold_over(const Expr& later) {
  if (is_quiet(later)) return Hold::kNow;
  return mutates(later) ? Hold::kOwn : Hold::kCall;
}

// ---- borrowing
// ----------------------------------------------------------------------------------------------------

Reg Lowering::borrow(const Expr& e, Hold hold) {
  if (hold != Hold::kOwn) {
    if (e.kind == ExprKind::kVariable) {
      code_.at(e.span, &e);
      return borrow_variable(*e.as<VariableExpr>().variable, hold);
    }
    if (e.kind == ExprKind::kConvert && e.as<ConvertExpr>().conversion == Conversion::kSame) {
      return borrow(*e.as<ConvertExpr>().operand, hold);
    }
    if (e.kind == ExprKind::kToText && is_text_already(e.as<ToTextExpr>())) {
      return borrow(*e.as<ToTextExpr>().value, hold);
    }
    if (belongs_to_other(e)) {
      const Reg to = code_.number();
      const Emitter::Mark mark = code_.mark();
      borrow_into(e, to, hold);
      code_.release_numbers(mark);
      return to;
    }
  }
  const Reg to = code_.reference();
  own_into(e, to);
  return to;
}

// Into a register that owns nothing: of a window, or a number register.
void Lowering::borrow_into(const Expr& e, Reg to, Hold hold) {
  std::string_view text;
  if (constant_text(e, text)) {
    code_.at(e.span, &e);
    code_.push(OpCode::TEXT, to.bits, tables_.text(text), 0);
    return;
  }
  if (hold != Hold::kOwn) {
    if (e.kind == ExprKind::kAbsent) return code_.emit(OpCode::ZERO, to);
    if (e.kind == ExprKind::kField) return load_field(e.as<FieldExpr>(), to, hold);
    if (e.kind == ExprKind::kElement) return load_element(e.as<ElementExpr>(), to, hold);
    if (e.kind == ExprKind::kEntry && !gives_other(e)) {
      return load_entry(e.as<EntryExpr>(), to, hold);
    }
  }
  code_.emit(OpCode::MOVE, to, borrow(e, hold));
}

Reg Lowering::borrow_variable(const Variable& variable, Hold hold) {
  Reg reg;
  if (variable.storage == Storage::kLocal) return reg_of(variable);
  check_set(variable);
  if (pinned_global(&variable, reg)) return reg;
  if (hold != Hold::kNow) {
    reg = code_.reference();
    own_variable(variable, reg);
    return reg;
  }
  reg = code_.number();
  if (variable.storage == Storage::kBoxed) {
    code_.emit(OpCode::BLOAD, reg, reg_of(variable));
  } else {
    code_.push(OpCode::GLOAD, reg.bits, variable.index, 0);
  }
  return reg;
}

Reg Lowering::null_reference() {
  const Reg reg = code_.number();
  code_.emit(OpCode::ZERO, reg);
  return reg;
}

// ---- counting
// -----------------------------------------------------------------------------------------------------

void Lowering::own_variable(const Variable& variable, Reg to) {
  Reg reg;
  if (variable.storage == Storage::kBoxed) {
    code_.emit(OpCode::BLOADREF, to, reg_of(variable));
  } else if (variable.storage == Storage::kLocal || pinned_global(&variable, reg)) {
    code_.emit(OpCode::MOVEREF, to, variable.storage == Storage::kLocal ? reg_of(variable) : reg);
  } else {
    code_.push(OpCode::GLOADREF, to.bits, variable.index, 0);
  }
}

// One count of the value goes to `to`, a reference register.
void Lowering::own_into(const Expr& e, Reg to) {
  std::string_view text;
  if (constant_text(e, text)) {
    code_.at(e.span, &e);
    code_.push(OpCode::TEXTREF, to.bits, tables_.text(text), 0);
    return;
  }
  const Emitter::Mark mark = code_.mark();
  if (e.kind == ExprKind::kVariable) {
    own_read(e.as<VariableExpr>(), to);
  } else if (e.kind == ExprKind::kAbsent) {
    code_.emit(OpCode::DROP, to);
  } else if (e.kind == ExprKind::kCond) {
    own_either(e.as<CondExpr>(), to);
  } else if (e.kind == ExprKind::kConvert) {
    own_converted(e.as<ConvertExpr>(), to);
  } else if (gives_other(e)) {
    own_entry_or(e.as<EntryExpr>(), to);
  } else if (belongs_to_other(e)) {
    const Reg borrowed = borrow(e, Hold::kNow);
    code_.emit(OpCode::MOVEREF, to, borrowed);
  } else {
    make(e, to);
  }
  code_.release(mark);
}

void Lowering::own_read(const VariableExpr& e, Reg to) {
  const Variable& variable = *e.variable;
  code_.at(e.span, &e);
  check_set(variable);
  if (whole_ == &e && may_be_last_use(e, variable)) {
    code_.push(OpCode::MOVEREF, to.bits, reg_of(variable).bits, 1);
  } else {
    own_variable(variable, to);
  }
}

void Lowering::own_either(const CondExpr& e, Reg to) {
  const Label no = code_.label();
  const Label end = code_.label();
  branch(*e.condition, false, no);
  own_into(*e.yes, to);
  code_.jump(end);
  code_.bind(no);
  own_into(*e.no, to);
  code_.bind(end);
}

void Lowering::own_converted(const ConvertExpr& e, Reg to) {
  if (e.conversion == Conversion::kSame) {
    own_into(*e.operand, to);
    return;
  }
  const Reg from = borrow(*e.operand, Hold::kNow);
  code_.at(e.span, &e);
  const bool rows = e.conversion == Conversion::kMatrixToRows;
  code_.emit(rows ? OpCode::ROWSOF : OpCode::LISTTOREAL, to, from);
}

// ---- making
// -------------------------------------------------------------------------------------------------------

// New objects.
void Lowering::make(const Expr& e, Reg to) {
  switch (e.kind) {
    case ExprKind::kList:
      return make_list(e.as<ListExpr>(), to);
    case ExprKind::kMap:
      return make_map(e.as<MapExpr>(), to);
    case ExprKind::kMapQuery:
      return make_map_list(e.as<MapQueryExpr>(), to);
    case ExprKind::kNewArray:
      return make_array(e.as<NewArrayExpr>(), to);
    case ExprKind::kRecord:
      return make_record(e.as<RecordExpr>(), to);
    case ExprKind::kSlice:
      return make_slice(e.as<SliceExpr>(), to);
    case ExprKind::kMatrix:
      return make_matrix(e.as<MatrixExpr>(), to);
    case ExprKind::kPart:
      return make_part(e.as<PartExpr>(), to);
    case ExprKind::kCharacter:
      return make_character(e.as<CharacterExpr>(), to);
    case ExprKind::kFunctionValue:
      return make_function(e.as<FunctionValueExpr>(), to);
    case ExprKind::kClosure:
      return make_closure(e.as<ClosureExpr>(), to);
    case ExprKind::kConcat:
      return join(e.as<ConcatExpr>(), to);
    case ExprKind::kToText:
      return to_text(e.as<ToTextExpr>(), to);
    case ExprKind::kError:
      return make_error(e.as<ErrorExpr>(), to);
    case ExprKind::kMutate:
      return code_.emit(OpCode::TAKE, to, mutate(e.as<MutateExpr>()));
    case ExprKind::kOverList:
      return over_list(e.as<OverListExpr>(), to);
    case ExprKind::kCall:
    case ExprKind::kCallValue:
    case ExprKind::kCallNative:
    case ExprKind::kGuarded:
      return call_own(e, to);
    case ExprKind::kBool:  // these are no objects
    case ExprKind::kInt:
    case ExprKind::kReal:
    case ExprKind::kEnum:
    case ExprKind::kUnary:
    case ExprKind::kBinary:
    case ExprKind::kAnd:
    case ExprKind::kOr:
    case ExprKind::kLength:
    case ExprKind::kText:  // and these are no new ones
    case ExprKind::kAbsent:
    case ExprKind::kVariable:
    case ExprKind::kCond:
    case ExprKind::kConvert:
    case ExprKind::kField:
    case ExprKind::kElement:
    case ExprKind::kEntry:
      break;
  }
  throw std::logic_error("no object to be made");
}

void Lowering::make_function(const FunctionValueExpr& e, Reg to) {
  code_.at(e.span, &e);
  code_.push(OpCode::CLOSURE, to.bits, 0, e.function->index);
}

void Lowering::make_list(const ListExpr& e, Reg to) {
  const Type* element = e.type->element;
  const bool references = element != nullptr && element->is_reference();
  Reg base;
  if (references) {
    for (std::size_t i = 0; i < e.items.size(); ++i) {
      const Reg item = code_.reference();
      if (i == 0) base = item;
      own_into(*e.items[i], item);
    }
  } else if (!e.items.empty()) {
    base = code_.number();
    window(e.items, base, Hold::kNow);
  }
  code_.at(e.span, &e);
  if (e.items.size() > UINT16_MAX) throw TooLarge{e.span, "values in one list", UINT16_MAX};
  code_.push(OpCode::MAKELIST, to.bits, base.bits, static_cast<std::uint32_t>(e.items.size()));
  code_.word(references ? 1 : 0);
  if (!references) return;
  for (std::uint32_t i = 0; i < e.items.size(); ++i) code_.set_owned(base.plus(i), false);
}

void Lowering::make_array(const NewArrayExpr& e, Reg to) {
  const Reg base = code_.number();
  window(e.sizes, base, Hold::kNow);
  code_.at(e.span, &e);
  const auto sizes = static_cast<std::uint32_t>(e.sizes.size());
  if (sizes == 1 && !e.type->element->is_reference()) {
    code_.push(OpCode::NEWLIST, to.bits, base.bits, 0);
    return;
  }
  code_.push(OpCode::NEWARRAY, to.bits, base.bits, sizes);
  code_.word(code_.type(e.type));
}

void Lowering::make_record(const RecordExpr& e, Reg to) {
  const Reg base = code_.number();
  window(e.fields, base, Hold::kNow);
  code_.at(e.span, &e);
  code_.push(OpCode::MAKEREC, to.bits, base.bits, tables_.layout(e.type));
}

// Lambdas copy what the variables hold; conditions share their boxes.
void Lowering::make_closure(const ClosureExpr& e, Reg to) {
  Reg base;
  code_.at(e.span, &e);
  for (std::size_t i = 0; i < e.function->captures.size(); ++i) {
    const auto& [outer, inner] = e.function->captures[i];
    const Reg slot = code_.number();
    if (i == 0) base = slot;
    if (outer->storage == Storage::kLocal || inner->storage == Storage::kBoxed) {
      code_.emit(OpCode::MOVE, slot, reg_of(*outer));
    } else {
      check_set(*outer);
      load_variable(*outer, slot);
    }
  }
  code_.push(OpCode::CLOSURE, to.bits, base.bits, e.function->index);
}

void Lowering::make_error(const ErrorExpr& e, Reg to) {
  const Hold hold = e.kind_text == nullptr ? Hold::kNow : hold_over(*e.kind_text);
  const Reg message = borrow(*e.message, hold);
  const Reg kind = e.kind_text == nullptr ? null_reference() : borrow(*e.kind_text, Hold::kNow);
  code_.at(e.span, &e);
  code_.emit(OpCode::MAKEERR, to, message, kind);
}

void Lowering::make_slice(const SliceExpr& e, Reg to) {
  Hold hold = Hold::kNow;
  for (const Expr* end : {e.first, e.last}) {
    if (end != nullptr) hold = stronger(hold, hold_over(*end));
  }
  const Reg object = borrow(*e.object, hold);
  const Reg first = code_.number();
  const Reg last = code_.number();
  for (const auto& [end, reg] : {std::pair{e.first, first}, std::pair{e.last, last}}) {
    if (end != nullptr) {
      value_into(*end, {reg, true});
    } else {
      code_.constant(reg, Slot{.i = kAbsentBits});
    }
  }
  code_.at(e.span, &e);
  const bool text = e.object->type->is(Kind::kText);
  code_.emit(text ? OpCode::SLICETEXT : OpCode::SLICE, to, object, first);
}

void Lowering::make_character(const CharacterExpr& e, Reg to) {
  const Reg text = borrow(*e.object, hold_over(*e.index));
  const Reg index = value(*e.index);
  code_.at(e.span, &e);
  code_.emit(OpCode::CHARAT, to, text, index);
}

// ---- texts
// --------------------------------------------------------------------------------------------------------

void Lowering::join(const ConcatExpr& e, Reg to) {
  std::vector<Expr*> parts = joined_parts(e);
  const Reg base = code_.number();
  window(parts, base, Hold::kNow);
  code_.at(e.span, &e);
  code_.push(OpCode::CONCAT, to.bits, base.bits, static_cast<std::uint32_t>(parts.size()));
}

// a + b + c is one joining of three texts, however it is nested.
std::vector<Expr*> Lowering::joined_parts(const ConcatExpr& e) {
  std::vector<Expr*> parts;
  std::vector<Expr*> open(e.parts.rbegin(), e.parts.rend());
  while (!open.empty()) {
    Expr* part = open.back();
    open.pop_back();
    std::string_view text;
    if (part->kind == ExprKind::kConcat && !constant_text(*part, text)) {
      const auto& inner = part->as<ConcatExpr>().parts;
      open.insert(open.end(), inner.rbegin(), inner.rend());
    } else {
      parts.push_back(part);
    }
  }
  if (parts.size() > UINT16_MAX) throw TooLarge{e.span, "texts joined at once", UINT16_MAX};
  return parts;
}

void Lowering::to_text(const ToTextExpr& e, Reg to) {
  if (is_text_already(e)) {
    own_into(*e.value, to);
    return;
  }
  const bool reference = e.value->type->is_reference();
  const Reg from = reference ? borrow(*e.value, Hold::kNow) : value(*e.value);
  check_whole(*e.value, from);
  const std::uint32_t format = tables_.format(
      {e.value->type, e.style, std::string(e.unit), e.unit.empty() ? 1.0 : e.factor});
  code_.at(e.span, &e);
  code_.push(OpCode::TOTEXT, to.bits, from.bits, format);
}

}  // namespace armlet::lang
