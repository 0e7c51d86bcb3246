// Expressions whose value is a number, truth value or choice: bits without a count.

#include <stdexcept>

#include "compile/lower/lowering.hpp"

namespace armlet::lang {

using namespace hir;

namespace {

bool is_arithmetic(Op op) { return op <= Op::kNegR; }
bool is_number_comparison(Op op) { return op >= Op::kLtI && op <= Op::kNeR; }
bool is_turned(Op op) {
  return op == Op::kGtI || op == Op::kGeI || op == Op::kGtR || op == Op::kGeR;
}

bool is_chain_link(const Expr& e) {
  Slot unused;
  return e.kind == ExprKind::kBinary && is_arithmetic(e.as<BinaryExpr>().op) &&
         !constant_slot(e, unused);
}

bool is_from_int(const Expr& e) {
  return e.kind == ExprKind::kConvert && e.as<ConvertExpr>().conversion == Conversion::kIntToReal;
}

bool is_field_of_element(const Expr& e) {
  return e.kind == ExprKind::kField && e.constant == nullptr && e.type->is(Kind::kReal) &&
         e.as<FieldExpr>().object->kind == ExprKind::kElement;
}

}  // namespace

bool is_product(const Expr& e) { return is_chain_link(e) && e.as<BinaryExpr>().op == Op::kMulR; }

// The value in a register that may belong to a variable: only to be read, and soon.
Reg Lowering::value(const Expr& e) {
  Reg reg;
  if (in_register(e, reg)) return reg;
  reg = code_.number();
  value_into(e, {reg, true});
  return reg;
}

// Like `value`, but computes in the target rather than in a new register, if it may.
Reg Lowering::value_near(const Expr& e, Dest hint) {
  Reg reg;
  if (in_register(e, reg)) return reg;
  if (!hint.early) return value(e);
  value_into(e, hint);
  return hint.reg;
}

bool Lowering::in_register(const Expr& e, Reg& out) {
  Slot slot;
  if (constant_slot(e, slot)) {
    return options_.optimise && loop_depth_ > 0 && code_.pinned_constant(slot, out);
  }
  if (e.kind == ExprKind::kConvert && e.as<ConvertExpr>().conversion == Conversion::kSame) {
    return in_register(*e.as<ConvertExpr>().operand, out);
  }
  if (e.kind != ExprKind::kVariable) return false;
  const Variable& variable = *e.as<VariableExpr>().variable;
  if (variable.storage == Storage::kLocal) {
    out = reg_of(variable);
    return true;
  }
  if (!pinned_global(&variable, out)) return false;
  code_.at(e.span, &e);
  check_set(variable);
  return true;
}

void Lowering::value_into(const Expr& e, Dest to) {
  Slot slot;
  Reg reg;
  if (constant_slot(e, slot)) {
    code_.at(e.span, &e);
    code_.constant(to.reg, slot);
    return;
  }
  if (in_register(e, reg)) {
    if (reg != to.reg) code_.emit(OpCode::MOVE, to.reg, reg);
    return;
  }
  const Emitter::Mark mark = code_.mark();
  compute(e, to);
  code_.release(mark);
}

void Lowering::compute(const Expr& e, Dest to) {
  code_.at(e.span, &e);
  switch (e.kind) {
    case ExprKind::kAbsent:
      return code_.constant(to.reg, Slot{.i = kAbsentBits});
    case ExprKind::kVariable:
      return read_variable(e.as<VariableExpr>(), to.reg);
    case ExprKind::kUnary:
      return unary_into(e.as<UnaryExpr>(), to);
    case ExprKind::kBinary:
    case ExprKind::kAnd:
    case ExprKind::kOr:
      return operator_into(e.as<BinaryExpr>(), to);
    case ExprKind::kCond:
      return cond_into(e.as<CondExpr>(), to);
    case ExprKind::kConvert:
      return convert_into(e.as<ConvertExpr>(), to);
    case ExprKind::kField:
      return load_field(e.as<FieldExpr>(), to.reg, Hold::kNow);
    case ExprKind::kElement:
      return load_element(e.as<ElementExpr>(), to.reg, Hold::kNow);
    case ExprKind::kEntry:
      return entry_into(e.as<EntryExpr>(), to.reg);
    case ExprKind::kMapQuery:
      return has_key_into(e.as<MapQueryExpr>(), to.reg);
    case ExprKind::kLength:
      return length_into(e.as<LengthExpr>(), to.reg);
    case ExprKind::kMutate:
      return code_.emit(OpCode::MOVE, to.reg, mutate(e.as<MutateExpr>()));
    case ExprKind::kOverList:
      return over_list(e.as<OverListExpr>(), to.reg);
    case ExprKind::kCall:
    case ExprKind::kCallValue:
    case ExprKind::kCallNative:
    case ExprKind::kGuarded:
      return call_into(e, to);
    case ExprKind::kBool:  // these are known
    case ExprKind::kInt:
    case ExprKind::kReal:
    case ExprKind::kEnum:
    case ExprKind::kText:  // and these are objects
    case ExprKind::kList:
    case ExprKind::kNewArray:
    case ExprKind::kRecord:
    case ExprKind::kSlice:
    case ExprKind::kCharacter:
    case ExprKind::kFunctionValue:
    case ExprKind::kClosure:
    case ExprKind::kConcat:
    case ExprKind::kToText:
    case ExprKind::kError:
    case ExprKind::kMatrix:
    case ExprKind::kPart:
    case ExprKind::kMap:
      break;
  }
  throw std::logic_error("no number to be computed");
}

void Lowering::read_variable(const VariableExpr& e, Reg to) {
  check_set(*e.variable);
  load_variable(*e.variable, to);
}

void Lowering::operator_into(const BinaryExpr& e, Dest to) {
  const bool computes = e.kind == ExprKind::kBinary && is_arithmetic(e.op);
  return computes ? binary_into(e, to) : truth_into(e, to);
}

void Lowering::entry_into(const EntryExpr& e, Reg to) {
  if (e.otherwise != nullptr) return own_entry_or(e, to);
  load_entry(e, to, Hold::kNow);
}

void Lowering::load_variable(const Variable& variable, Reg to) {
  if (variable.storage == Storage::kBoxed) {
    code_.emit(OpCode::BLOAD, to, reg_of(variable));
  } else {
    code_.push(OpCode::GLOAD, to.bits, variable.index, 0);
  }
}

void Lowering::unary_into(const UnaryExpr& e, Dest to) {
  const Reg operand = value_near(*e.operand, to);
  code_.at(e.span, &e);
  code_.emit(arithmetic_instruction(e.op), to.reg, operand);
}

// A chain such as a + b * c - d is a loop from its innermost left operand on.
void Lowering::binary_into(const BinaryExpr& e, Dest to) {
  std::vector<const BinaryExpr*> chain{&e};
  const Expr* first = e.left;
  for (; is_chain_link(*first); first = first->as<BinaryExpr>().left) {
    chain.push_back(&first->as<BinaryExpr>());
  }
  const bool needs_own = !to.early && chain.size() > 1;
  const Reg between = needs_own ? code_.number() : to.reg;
  std::size_t links = chain.size();
  Reg result = between;
  if (turned(*chain.back(), between)) {
    --links;
  } else {
    result = value_near(*first, {between, to.early || needs_own});
  }
  for (std::size_t i = links; i-- > 0;) {
    const Emitter::Mark mark = code_.mark();
    const BinaryExpr& link = *chain[i];
    if (i > 0 && add_to_product(link, *chain[i - 1], result, i == 1 ? to.reg : between)) {
      --i;
    } else {
      arithmetic({link.span, &link}, link.op, result, *link.right, i == 0 ? to.reg : between);
    }
    code_.release(mark);
    result = i == 0 ? to.reg : between;
  }
}

// to = left op right. Nothing is written to `to` before the right side has been evaluated.
void Lowering::arithmetic(Site site, Op op, Reg left, const Expr& right, Reg to) {
  if (options_.optimise) {
    if (multiply_add(site, op, left, right, to)) return;
    if (with_small(site, op, left, right, to) || by_power_of_two(site, op, left, right, to)) return;
    if (with_int(site, op, left, right, to) || with_field(site, op, left, right, to)) return;
    if (with_constant(site, op, left, right, to)) return;
    if (left == to && op == Op::kMulR && multiply_element(right, to)) return;
  }
  const Reg other = value(right);
  code_.at(site.span, site.expr);
  code_.emit(arithmetic_instruction(op), to, left, other);
}

// x + a * b. The product is rounded, then the sum: the same bits as two instructions.
bool Lowering::multiply_add(Site site, Op op, Reg left, const Expr& right, Reg to) {
  if (op != Op::kAddR && (op != Op::kSubR || left != to)) return false;
  if (!is_product(right)) return false;
  const auto& product = right.as<BinaryExpr>();
  const Reg a = value(*product.left);
  if (left == to && op == Op::kAddR && add_product_of_element(site, a, *product.right, to)) {
    return true;
  }
  const Reg b = value(*product.right);
  code_.at(site.span, site.expr);
  if (left == to) {
    code_.emit(op == Op::kAddR ? OpCode::MADD : OpCode::MSUB, to, a, b);
  } else {
    code_.emit(OpCode::MULADD, to, a, b);
    code_.emit(OpCode::WITH, left);
  }
  return true;
}

// a * b + x where x is in a register already; `left` is a.
bool Lowering::add_to_product(const BinaryExpr& product, const BinaryExpr& sum, Reg left, Reg to) {
  Reg added;
  if (!options_.optimise || product.op != Op::kMulR || sum.op != Op::kAddR) return false;
  if (!in_register(*sum.right, added)) return false;
  const Reg factor = value(*product.right);
  code_.at(sum.span, &sum);
  code_.emit(OpCode::MULADD, to, left, factor);
  code_.emit(OpCode::WITH, added);
  return true;
}

// x + i where the int i is converted: one instruction.
bool Lowering::with_int(Site site, Op op, Reg left, const Expr& right, Reg to) {
  Slot known;
  const OpCode variant = variant_of(Variant::kWithInt, arithmetic_instruction(op));
  if (variant == kNoVariant || !is_from_int(right) || constant_slot(right, known)) return false;
  const Reg number = value(*right.as<ConvertExpr>().operand);
  code_.at(site.span, site.expr);
  code_.emit(variant, to, left, number);
  return true;
}

// x - xs[i].field
bool Lowering::with_field(Site site, Op op, Reg left, const Expr& right, Reg to) {
  const OpCode variant = variant_of(Variant::kFieldOfElement, arithmetic_instruction(op));
  if (variant == kNoVariant || !is_field_of_element(right)) return false;
  if (may_be_unset(*right.as<FieldExpr>().object->type)) return false;
  const auto& element = right.as<FieldExpr>().object->as<ElementExpr>();
  const Reg list = borrow(*element.object, hold_over(*element.index));
  const Reg index = value(*element.index);
  code_.at(element.span, &element);
  code_.emit(variant, to, list, index);
  code_.at(site.span, site.expr);
  code_.push(OpCode::FACTORS, left.bits, left.bits, right.as<FieldExpr>().field);
  return true;
}

// 1.5 * x, 2 * i; i * x and xs[i].field * x with x in a register: the sides change places, the bits
// stay.
bool Lowering::turned(const BinaryExpr& e, Reg to) {
  Reg right;
  std::int64_t small = 0;
  if (!options_.optimise) return false;
  if ((e.op == Op::kAddI || e.op == Op::kMulI) && small_int(*e.left, small)) {
    return with_small({e.span, &e}, e.op, value(*e.right), *e.left, to);
  }
  if (e.op != Op::kAddR && e.op != Op::kMulR) return false;
  Slot known;
  if (constant_slot(*e.left, known)) {
    return !in_register(*e.left, right) &&
           with_constant({e.span, &e}, e.op, value(*e.right), *e.left, to);
  }
  if (!is_from_int(*e.left) && !is_field_of_element(*e.left)) return false;
  if (!in_register(*e.right, right)) return false;
  return with_int({e.span, &e}, e.op, right, *e.left, to) ||
         with_field({e.span, &e}, e.op, right, *e.left, to);
}

// x += a * xs[i], x += a * rows[i][j]; a has been evaluated.
bool Lowering::add_product_of_element(Site site, Reg a, const Expr& b, Reg to) {
  if (b.kind != ExprKind::kElement || b.constant != nullptr) return false;
  const auto& element = b.as<ElementExpr>();
  if (element.column != nullptr) return false;
  const bool twice = element.object->kind == ExprKind::kElement && is_plain(*element.index);
  const auto& inner = twice ? element.object->as<ElementExpr>() : element;
  const Hold hold = hold_over(*inner.index);
  const Reg list = borrow(*inner.object, hold);
  const Reg i = value(*inner.index);
  const Reg j = twice ? value(*element.index) : Reg{};
  code_.at(inner.span, &inner);
  code_.emit(twice ? OpCode::MADDLDLD : OpCode::MADDLD, to, list, i);
  if (twice) {
    code_.at(element.span, &element);
    code_.emit(OpCode::PAIR, a, j);
  } else {
    code_.at(site.span, site.expr);
    code_.emit(OpCode::WITH, a);
  }
  return true;
}

bool Lowering::multiply_element(const Expr& right, Reg accumulator) {
  if (right.kind != ExprKind::kElement || right.constant != nullptr) return false;
  const auto& element = right.as<ElementExpr>();
  if (element.column != nullptr) return false;
  const Reg list = borrow(*element.object, hold_over(*element.index));
  const Reg index = value(*element.index);
  code_.at(right.span, &right);
  code_.emit(OpCode::LDMUL, accumulator, list, index);
  return true;
}

void Lowering::truth_into(const Expr& e, Dest to) {
  if (e.kind == ExprKind::kBinary && is_number_comparison(e.as<BinaryExpr>().op)) {
    const auto& binary = e.as<BinaryExpr>();
    const Reg left = value(*binary.left);
    const Reg right = value(*binary.right);
    const bool turned = is_turned(binary.op);
    code_.at(e.span, &e);
    code_.emit(arithmetic_instruction(binary.op), to.reg, turned ? right : left,
               turned ? left : right);
    return;
  }
  const Label no = code_.label();
  const Label end = code_.label();
  branch(e, false, no);
  code_.constant(to.reg, slot_of(true));
  code_.jump(end);
  code_.bind(no);
  code_.constant(to.reg, slot_of(false));
  code_.bind(end);
}

void Lowering::cond_into(const CondExpr& e, Dest to) {
  const Label no = code_.label();
  const Label end = code_.label();
  branch(*e.condition, false, no);
  value_into(*e.yes, to);
  code_.jump(end);
  code_.bind(no);
  value_into(*e.no, to);
  code_.bind(end);
}

void Lowering::convert_into(const ConvertExpr& e, Dest to) {
  if (e.conversion == Conversion::kSame) {
    value_into(*e.operand, to);
    return;
  }
  const Reg operand = value_near(*e.operand, to);
  code_.at(e.span, &e);
  code_.emit(e.conversion == Conversion::kIntToReal ? OpCode::ITOR : OpCode::RTOI, to.reg, operand);
}

void Lowering::length_into(const LengthExpr& e, Reg to) {
  const Reg object = borrow(*e.object, Hold::kNow);
  code_.at(e.span, &e);
  const Type& type = *e.object->type;
  const OpCode length = type.is(Kind::kText)  ? OpCode::LENTEXT
                        : type.is(Kind::kMap) ? OpCode::MAPLEN
                                              : OpCode::LEN;
  code_.emit(length, to, object);
}

// ---- fields and elements, also as borrowed references
// --------------------------------------------------------------

void Lowering::load_field(const FieldExpr& e, Reg to, Hold hold) {
  if (options_.optimise && e.object->kind == ExprKind::kElement && !may_be_unset(*e.object->type)) {
    const auto& element = e.object->as<ElementExpr>();
    const Reg list = borrow(*element.object, stronger(hold, hold_over(*element.index)));
    const Reg index = value(*element.index);
    code_.at(element.span, &element);
    code_.emit(OpCode::LDF, to, list, index);
    code_.word(e.field);
    return;
  }
  const Reg record = borrow(*e.object, hold);
  code_.at(e.span, &e);
  code_.push(OpCode::FLD, to.bits, record.bits, e.field);
}

// rows[i][j], where evaluating j neither fails nor runs anything.
bool Lowering::load_element_twice(const ElementExpr& e, Reg to, Hold hold) {
  if (!options_.optimise || e.object->kind != ExprKind::kElement || !is_plain(*e.index))
    return false;
  const auto& row = e.object->as<ElementExpr>();
  const Reg rows = borrow(*row.object, stronger(hold, hold_over(*row.index)));
  const Reg i = value(*row.index);
  const Reg j = value(*e.index);
  code_.at(row.span, &row);
  code_.emit(OpCode::LDLD, to, rows, i);
  code_.at(e.span, &e);
  code_.emit(OpCode::WITH, j);
  return true;
}

void Lowering::load_element(const ElementExpr& e, Reg to, Hold hold) {
  if (e.column != nullptr) return load_matrix_element(e, to, hold);
  const bool may_fail = may_be_unset(*e.type);
  if (!may_fail && load_element_twice(e, to, hold)) return;
  const Reg list = borrow(*e.object, stronger(hold, hold_over(*e.index)));
  std::int64_t small = 0;
  if (options_.optimise && !may_fail && small_int(*e.index, small)) {
    code_.at(e.span, &e);
    code_.push(OpCode::LDI, to.bits, list.bits, static_cast<std::uint16_t>(small));
    return;
  }
  const Reg index = value(*e.index);
  code_.at(e.span, &e);
  code_.emit(may_fail ? OpCode::LDSET : OpCode::LD, to, list, index);
}

}  // namespace armlet::lang
