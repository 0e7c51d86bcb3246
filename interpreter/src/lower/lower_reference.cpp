// Compiles expressions whose value is an object: texts, lists, records, closures, values of the
// host.

#include <algorithm>
#include <stdexcept>

#include "lower/places.hpp"
#include "lower/statements.hpp"
#include "lower/values.hpp"

namespace armlet::lang {

using namespace hir;

static void make_function(Lowering& in, const FunctionValueExpr& e, Reg to);
static void own_read(Lowering& in, const VariableExpr& e, Reg to);
static void own_variable(Lowering& in, const Variable& variable, Reg to);
static void own_either(Lowering& in, const CondExpr& e, Reg to);
static void own_converted(Lowering& in, const ConvertExpr& e, Reg to);
static void make(Lowering& in, const Expr& e, Reg to);
static void make_list(Lowering& in, const ListExpr& e, Reg to);
static void make_array(Lowering& in, const NewArrayExpr& e, Reg to);
static void make_record(Lowering& in, const RecordExpr& e, Reg to);
static void make_closure(Lowering& in, const ClosureExpr& e, Reg to);
static void make_error(Lowering& in, const ErrorExpr& e, Reg to);
static void make_slice(Lowering& in, const SliceExpr& e, Reg to);
static void make_character(Lowering& in, const CharacterExpr& e, Reg to);
static void join(Lowering& in, const ConcatExpr& e, Reg to);
static void to_text(Lowering& in, const ToTextExpr& e, Reg to);

namespace {

// print(x) of a text shows the text itself.
bool is_text_already(const ToTextExpr& e) {
  return e.value->type->is(Kind::kText) && e.style.is_plain() && e.unit.empty();
}

// Whether the expression is m.get(k, other).
bool gives_other(const Expr& e) {
  return e.kind == ExprKind::kEntry && e.as<EntryExpr>().otherwise != nullptr;
}

// Whether the value has another owner: a variable, or a list or record that is kept elsewhere.
bool belongs_to_other(const Expr& e) {
  return !gives_other(e) && is_one_of(e.kind, {ExprKind::kText, ExprKind::kAbsent, ExprKind::kField,
                                               ExprKind::kEntry, ExprKind::kElement});
}

// The characters of a constant text.
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

Hold hold_over(const Lowering& in, const Expr& later) {
  if (is_quiet(later, in.tables.inlined())) return Hold::kNow;
  return mutates(later) ? Hold::kOwn : Hold::kCall;
}

// ---- borrowing

Reg borrow(Lowering& in, const Expr& e, Hold hold) {
  if (hold != Hold::kOwn) {
    if (e.kind == ExprKind::kVariable) {
      in.code.at(e.span, &e);
      return borrow_variable(in, *e.as<VariableExpr>().variable, hold);
    }
    if (e.kind == ExprKind::kConvert && e.as<ConvertExpr>().conversion == Conversion::kSame) {
      return borrow(in, *e.as<ConvertExpr>().operand, hold);
    }
    if (e.kind == ExprKind::kToText && is_text_already(e.as<ToTextExpr>())) {
      return borrow(in, *e.as<ToTextExpr>().value, hold);
    }
    if (belongs_to_other(e)) {
      const Reg to = in.code.number();
      const Emitter::Mark mark = in.code.mark();
      borrow_into(in, e, to, hold);
      in.code.release_numbers(mark);
      return to;
    }
  }
  const Reg to = in.code.reference();
  own_into(in, e, to);
  return to;
}

// Loads a borrowed reference into a register that owns nothing: a number register, such as one of a
// window.
void borrow_into(Lowering& in, const Expr& e, Reg to, Hold hold) {
  std::string_view text;
  if (constant_text(e, text)) {
    in.code.at(e.span, &e);
    in.code.push(OpCode::TEXT, to.bits, in.tables.text(text), 0);
    return;
  }
  if (hold != Hold::kOwn) {
    if (e.kind == ExprKind::kAbsent) return in.code.emit(OpCode::ZERO, to);
    if (e.kind == ExprKind::kField) return load_field(in, e.as<FieldExpr>(), to, hold);
    if (e.kind == ExprKind::kElement) return load_element(in, e.as<ElementExpr>(), to, hold);
    if (e.kind == ExprKind::kEntry && !gives_other(e)) {
      return load_entry(in, e.as<EntryExpr>(), to, hold);
    }
  }
  in.code.emit(OpCode::MOVE, to, borrow(in, e, hold));
}

Reg borrow_variable(Lowering& in, const Variable& variable, Hold hold) {
  Reg reg;
  if (variable.storage == Storage::kLocal) return in.homes.of(variable);
  check_set(in, variable);
  if (in.loops.is_pinned(variable, reg)) return reg;
  if (hold != Hold::kNow) {
    reg = in.code.reference();
    own_variable(in, variable, reg);
    return reg;
  }
  reg = in.code.number();
  if (variable.storage == Storage::kBoxed) {
    in.code.emit(OpCode::BLOAD, reg, in.homes.of(variable));
  } else {
    in.code.push(OpCode::GLOAD, reg.bits, variable.index, 0);
  }
  return reg;
}

Reg null_reference(Lowering& in) {
  const Reg reg = in.code.number();
  in.code.emit(OpCode::ZERO, reg);
  return reg;
}

// ---- counting

static void own_variable(Lowering& in, const Variable& variable, Reg to) {
  Reg reg;
  if (variable.storage == Storage::kBoxed) {
    in.code.emit(OpCode::BLOADREF, to, in.homes.of(variable));
  } else if (variable.storage == Storage::kLocal || in.loops.is_pinned(variable, reg)) {
    in.code.emit(OpCode::MOVEREF, to,
                 variable.storage == Storage::kLocal ? in.homes.of(variable) : reg);
  } else {
    in.code.push(OpCode::GLOADREF, to.bits, variable.index, 0);
  }
}

// Evaluates into a reference register, which then owns one count of the value.
void own_into(Lowering& in, const Expr& e, Reg to) {
  std::string_view text;
  if (constant_text(e, text)) {
    in.code.at(e.span, &e);
    in.code.push(OpCode::TEXTREF, to.bits, in.tables.text(text), 0);
    return;
  }
  const Emitter::Mark mark = in.code.mark();
  if (e.kind == ExprKind::kVariable) {
    own_read(in, e.as<VariableExpr>(), to);
  } else if (e.kind == ExprKind::kAbsent) {
    in.code.emit(OpCode::DROP, to);
  } else if (e.kind == ExprKind::kCond) {
    own_either(in, e.as<CondExpr>(), to);
  } else if (e.kind == ExprKind::kConvert) {
    own_converted(in, e.as<ConvertExpr>(), to);
  } else if (gives_other(e)) {
    own_entry_or(in, e.as<EntryExpr>(), to);
  } else if (belongs_to_other(e)) {
    const Reg borrowed = borrow(in, e, Hold::kNow);
    in.code.emit(OpCode::MOVEREF, to, borrowed);
  } else {
    make(in, e, to);
  }
  in.code.release(mark);
}

static void own_read(Lowering& in, const VariableExpr& e, Reg to) {
  const Variable& variable = *e.variable;
  in.code.at(e.span, &e);
  check_set(in, variable);
  if (in.uses.is_whole(e) && may_be_last_use(in, e, variable)) {
    in.code.push(OpCode::MOVEREF, to.bits, in.homes.of(variable).bits, 1);
  } else {
    own_variable(in, variable, to);
  }
}

static void own_either(Lowering& in, const CondExpr& e, Reg to) {
  const Label no = in.code.label();
  const Label end = in.code.label();
  branch(in, *e.condition, false, no);
  own_into(in, *e.yes, to);
  in.code.jump(end);
  in.code.bind(no);
  own_into(in, *e.no, to);
  in.code.bind(end);
}

static void own_converted(Lowering& in, const ConvertExpr& e, Reg to) {
  if (e.conversion == Conversion::kSame) {
    own_into(in, *e.operand, to);
    return;
  }
  const Reg from = borrow(in, *e.operand, Hold::kNow);
  in.code.at(e.span, &e);
  const bool rows = e.conversion == Conversion::kMatrixToRows;
  in.code.emit(rows ? OpCode::ROWSOF : OpCode::LISTTOREAL, to, from);
}

// ---- making

// Makes a new object.
static void make(Lowering& in, const Expr& e, Reg to) {
  switch (e.kind) {
    case ExprKind::kList:
      return make_list(in, e.as<ListExpr>(), to);
    case ExprKind::kMap:
      return make_map(in, e.as<MapExpr>(), to);
    case ExprKind::kMapQuery:
      return make_map_list(in, e.as<MapQueryExpr>(), to);
    case ExprKind::kNewArray:
      return make_array(in, e.as<NewArrayExpr>(), to);
    case ExprKind::kRecord:
      return make_record(in, e.as<RecordExpr>(), to);
    case ExprKind::kSlice:
      return make_slice(in, e.as<SliceExpr>(), to);
    case ExprKind::kMatrix:
      return make_matrix(in, e.as<MatrixExpr>(), to);
    case ExprKind::kPart:
      return make_part(in, e.as<PartExpr>(), to);
    case ExprKind::kCharacter:
      return make_character(in, e.as<CharacterExpr>(), to);
    case ExprKind::kFunctionValue:
      return make_function(in, e.as<FunctionValueExpr>(), to);
    case ExprKind::kClosure:
      return make_closure(in, e.as<ClosureExpr>(), to);
    case ExprKind::kConcat:
      return join(in, e.as<ConcatExpr>(), to);
    case ExprKind::kToText:
      return to_text(in, e.as<ToTextExpr>(), to);
    case ExprKind::kError:
      return make_error(in, e.as<ErrorExpr>(), to);
    case ExprKind::kMutate:
      return in.code.emit(OpCode::TAKE, to, mutate(in, e.as<MutateExpr>()));
    case ExprKind::kOverList:
      return over_list(in, e.as<OverListExpr>(), to);
    case ExprKind::kCall:
    case ExprKind::kCallValue:
    case ExprKind::kCallNative:
    case ExprKind::kGuarded:
      return call_own(in, e, to);
    case ExprKind::kBool:  // no objects
    case ExprKind::kInt:
    case ExprKind::kReal:
    case ExprKind::kEnum:
    case ExprKind::kUnary:
    case ExprKind::kBinary:
    case ExprKind::kAnd:
    case ExprKind::kOr:
    case ExprKind::kLength:
    case ExprKind::kText:  // not new objects
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

static void make_function(Lowering& in, const FunctionValueExpr& e, Reg to) {
  in.code.at(e.span, &e);
  in.code.push(OpCode::CLOSURE, to.bits, 0, e.function->index);
}

static void make_list(Lowering& in, const ListExpr& e, Reg to) {
  const Type* element = e.type->element;
  const bool references = element != nullptr && element->is_reference();
  Reg base;
  if (references) {
    for (std::size_t i = 0; i < e.items.size(); ++i) {
      const Reg item = in.code.reference();
      if (i == 0) base = item;
      own_into(in, *e.items[i], item);
    }
  } else if (!e.items.empty()) {
    base = in.code.number();
    window(in, e.items, base, Hold::kNow);
  }
  in.code.at(e.span, &e);
  if (e.items.size() > UINT16_MAX) throw TooLarge{e.span, "values in one list", UINT16_MAX};
  in.code.push(OpCode::MAKELIST, to.bits, base.bits, static_cast<std::uint32_t>(e.items.size()));
  in.code.word(references ? 1 : 0);
  if (!references) return;
  for (std::uint32_t i = 0; i < e.items.size(); ++i) in.code.set_owned(base.plus(i), false);
}

static void make_array(Lowering& in, const NewArrayExpr& e, Reg to) {
  const Reg base = in.code.number();
  window(in, e.sizes, base, Hold::kNow);
  in.code.at(e.span, &e);
  const auto sizes = static_cast<std::uint32_t>(e.sizes.size());
  if (sizes == 1 && !e.type->element->is_reference()) {
    in.code.push(OpCode::NEWLIST, to.bits, base.bits, 0);
    return;
  }
  in.code.push(OpCode::NEWARRAY, to.bits, base.bits, sizes);
  in.code.word(in.code.type(e.type));
}

static void make_record(Lowering& in, const RecordExpr& e, Reg to) {
  const Reg base = in.code.number();
  window(in, e.fields, base, Hold::kNow);
  in.code.at(e.span, &e);
  in.code.push(OpCode::MAKEREC, to.bits, base.bits, in.tables.layout(e.type));
}

// Closures of lambdas copy the values of variables; those of conditions share the boxes of
// variables.
static void make_closure(Lowering& in, const ClosureExpr& e, Reg to) {
  Reg base;
  in.code.at(e.span, &e);
  for (std::size_t i = 0; i < e.function->captures.size(); ++i) {
    const auto& [outer, inner] = e.function->captures[i];
    const Reg slot = in.code.number();
    if (i == 0) base = slot;
    if (outer->storage == Storage::kLocal || inner->storage == Storage::kBoxed) {
      in.code.emit(OpCode::MOVE, slot, in.homes.of(*outer));
    } else {
      check_set(in, *outer);
      load_variable(in, *outer, slot);
    }
  }
  in.code.push(OpCode::CLOSURE, to.bits, base.bits, e.function->index);
}

static void make_error(Lowering& in, const ErrorExpr& e, Reg to) {
  const Hold hold = e.kind_text == nullptr ? Hold::kNow : hold_over(in, *e.kind_text);
  const Reg message = borrow(in, *e.message, hold);
  const Reg kind =
      e.kind_text == nullptr ? null_reference(in) : borrow(in, *e.kind_text, Hold::kNow);
  in.code.at(e.span, &e);
  in.code.emit(OpCode::MAKEERR, to, message, kind);
}

static void make_slice(Lowering& in, const SliceExpr& e, Reg to) {
  Hold hold = Hold::kNow;
  for (const Expr* end : {e.first, e.last}) {
    if (end != nullptr) hold = stronger(hold, hold_over(in, *end));
  }
  const Reg object = borrow(in, *e.object, hold);
  const Reg first = in.code.number();
  const Reg last = in.code.number();
  for (const auto& [end, reg] : {std::pair{e.first, first}, std::pair{e.last, last}}) {
    if (end != nullptr) {
      value_into(in, *end, {reg, true});
    } else {
      in.code.constant(reg, Slot{.i = kAbsentBits});
    }
  }
  in.code.at(e.span, &e);
  const bool text = e.object->type->is(Kind::kText);
  in.code.emit(text ? OpCode::SLICETEXT : OpCode::SLICE, to, object, first);
}

static void make_character(Lowering& in, const CharacterExpr& e, Reg to) {
  const Reg text = borrow(in, *e.object, hold_over(in, *e.index));
  const Reg index = value(in, *e.index);
  in.code.at(e.span, &e);
  in.code.emit(OpCode::CHARAT, to, text, index);
}

// ---- texts

static void join(Lowering& in, const ConcatExpr& e, Reg to) {
  std::vector<Expr*> parts = joined_parts(e);
  const Reg base = in.code.number();
  window(in, parts, base, Hold::kNow);
  in.code.at(e.span, &e);
  in.code.push(OpCode::CONCAT, to.bits, base.bits, static_cast<std::uint32_t>(parts.size()));
}

// a + b + c is compiled to one joining of three texts, however it is nested.
std::vector<Expr*> joined_parts(const ConcatExpr& e) {
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

static void to_text(Lowering& in, const ToTextExpr& e, Reg to) {
  if (is_text_already(e)) {
    own_into(in, *e.value, to);
    return;
  }
  const bool reference = e.value->type->is_reference();
  const Reg from = reference ? borrow(in, *e.value, Hold::kNow) : value(in, *e.value);
  check_whole(in, *e.value, from);
  const std::uint32_t format = in.tables.format(
      {e.value->type, e.style, std::string(e.unit), e.unit.empty() ? 1.0 : e.factor});
  in.code.at(e.span, &e);
  in.code.push(OpCode::TOTEXT, to.bits, from.bits, format);
}

}  // namespace armlet::lang
