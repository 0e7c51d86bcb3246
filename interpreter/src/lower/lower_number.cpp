// Compiles expressions whose value is a number, a bool or an enum value: bits without a count.

#include <stdexcept>

#include "lower/places.hpp"
#include "lower/statements.hpp"
#include "lower/values.hpp"

namespace armlet::lang {

using namespace hir;

static void read_variable(Lowering& in, const VariableExpr& e, Reg to);
static void operator_into(Lowering& in, const BinaryExpr& e, Dest to);
static void entry_into(Lowering& in, const EntryExpr& e, Reg to);
static void compute(Lowering& in, const Expr& e, Dest to);
static void unary_into(Lowering& in, const UnaryExpr& e, Dest to);
static void binary_into(Lowering& in, const BinaryExpr& e, Dest to);
static bool multiply_add(Lowering& in, Site site, Op op, Reg left, const Expr& right, Reg to);
static bool add_to_product(Lowering& in, const BinaryExpr& product, const BinaryExpr& sum, Reg left,
                           Reg to);
static bool with_int(Lowering& in, Site site, Op op, Reg left, const Expr& right, Reg to);
static bool with_field(Lowering& in, Site site, Op op, Reg left, const Expr& right, Reg to);
static bool turned(Lowering& in, const BinaryExpr& e, Reg to);
static bool add_product_of_element(Lowering& in, Site site, Reg a, const Expr& b, Reg to);
static bool multiply_element(Lowering& in, const Expr& right, Reg accumulator);
static void truth_into(Lowering& in, const Expr& e, Dest to);
static void cond_into(Lowering& in, const CondExpr& e, Dest to);
static void convert_into(Lowering& in, const ConvertExpr& e, Dest to);
static void length_into(Lowering& in, const LengthExpr& e, Reg to);
static bool load_element_twice(Lowering& in, const ElementExpr& e, Reg to, Hold hold);

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

// The register of the value, which may be that of a variable: the caller must not write to it, and
// must read it before the variable changes.
Reg value(Lowering& in, const Expr& e) {
  Reg reg;
  if (in_register(in, e, reg)) return reg;
  reg = in.code.number();
  value_into(in, e, {reg, true});
  return reg;
}

// Like `value`, but computes into the destination `hint` instead of a new register, if that is
// allowed.
Reg value_near(Lowering& in, const Expr& e, Dest hint) {
  Reg reg;
  if (in_register(in, e, reg)) return reg;
  if (!hint.early) return value(in, e);
  value_into(in, e, hint);
  return hint.reg;
}

bool in_register(Lowering& in, const Expr& e, Reg& out) {
  Slot slot;
  if (constant_slot(e, slot)) {
    return in.options.optimise && in.loops.any() && in.code.pinned_constant(slot, out);
  }
  if (e.kind == ExprKind::kConvert && e.as<ConvertExpr>().conversion == Conversion::kSame) {
    return in_register(in, *e.as<ConvertExpr>().operand, out);
  }
  if (e.kind != ExprKind::kVariable) return false;
  const Variable& variable = *e.as<VariableExpr>().variable;
  if (variable.storage == Storage::kLocal) {
    out = in.homes.of(variable);
    return true;
  }
  if (!in.loops.is_pinned(variable, out)) return false;
  in.code.at(e.span, &e);
  check_set(in, variable);
  return true;
}

void value_into(Lowering& in, const Expr& e, Dest to) {
  Slot slot;
  Reg reg;
  if (constant_slot(e, slot)) {
    in.code.at(e.span, &e);
    in.code.constant(to.reg, slot);
    return;
  }
  if (in_register(in, e, reg)) {
    if (reg != to.reg) in.code.emit(OpCode::MOVE, to.reg, reg);
    return;
  }
  const Emitter::Mark mark = in.code.mark();
  compute(in, e, to);
  in.code.release(mark);
}

static void compute(Lowering& in, const Expr& e, Dest to) {
  in.code.at(e.span, &e);
  switch (e.kind) {
    case ExprKind::kAbsent:
      return in.code.constant(to.reg, Slot{.i = kAbsentBits});
    case ExprKind::kVariable:
      return read_variable(in, e.as<VariableExpr>(), to.reg);
    case ExprKind::kUnary:
      return unary_into(in, e.as<UnaryExpr>(), to);
    case ExprKind::kBinary:
    case ExprKind::kAnd:
    case ExprKind::kOr:
      return operator_into(in, e.as<BinaryExpr>(), to);
    case ExprKind::kCond:
      return cond_into(in, e.as<CondExpr>(), to);
    case ExprKind::kConvert:
      return convert_into(in, e.as<ConvertExpr>(), to);
    case ExprKind::kField:
      return load_field(in, e.as<FieldExpr>(), to.reg, Hold::kNow);
    case ExprKind::kElement:
      return load_element(in, e.as<ElementExpr>(), to.reg, Hold::kNow);
    case ExprKind::kEntry:
      return entry_into(in, e.as<EntryExpr>(), to.reg);
    case ExprKind::kMapQuery:
      return has_key_into(in, e.as<MapQueryExpr>(), to.reg);
    case ExprKind::kLength:
      return length_into(in, e.as<LengthExpr>(), to.reg);
    case ExprKind::kMutate:
      return in.code.emit(OpCode::MOVE, to.reg, mutate(in, e.as<MutateExpr>()));
    case ExprKind::kOverList:
      return over_list(in, e.as<OverListExpr>(), to.reg);
    case ExprKind::kCall:
    case ExprKind::kCallValue:
    case ExprKind::kCallNative:
    case ExprKind::kGuarded:
      return call_into(in, e, to);
    case ExprKind::kBool:  // constants
    case ExprKind::kInt:
    case ExprKind::kReal:
    case ExprKind::kEnum:
    case ExprKind::kText:  // objects
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

static void read_variable(Lowering& in, const VariableExpr& e, Reg to) {
  check_set(in, *e.variable);
  load_variable(in, *e.variable, to);
}

static void operator_into(Lowering& in, const BinaryExpr& e, Dest to) {
  const bool computes = e.kind == ExprKind::kBinary && is_arithmetic(e.op);
  return computes ? binary_into(in, e, to) : truth_into(in, e, to);
}

static void entry_into(Lowering& in, const EntryExpr& e, Reg to) {
  if (e.otherwise != nullptr) return own_entry_or(in, e, to);
  load_entry(in, e, to, Hold::kNow);
}

void load_variable(Lowering& in, const Variable& variable, Reg to) {
  if (variable.storage == Storage::kBoxed) {
    in.code.emit(OpCode::BLOAD, to, in.homes.of(variable));
  } else {
    in.code.push(OpCode::GLOAD, to.bits, variable.index, 0);
  }
}

static void unary_into(Lowering& in, const UnaryExpr& e, Dest to) {
  const Reg operand = value_near(in, *e.operand, to);
  in.code.at(e.span, &e);
  in.code.emit(arithmetic_instruction(e.op), to.reg, operand);
}

// A chain such as a + b * c - d is compiled by a loop from its innermost left operand on, so that
// long chains need no stack.
static void binary_into(Lowering& in, const BinaryExpr& e, Dest to) {
  std::vector<const BinaryExpr*> chain{&e};
  const Expr* first = e.left;
  for (; is_chain_link(*first); first = first->as<BinaryExpr>().left) {
    chain.push_back(&first->as<BinaryExpr>());
  }
  const bool needs_own = !to.early && chain.size() > 1;
  const Reg between = needs_own ? in.code.number() : to.reg;
  std::size_t links = chain.size();
  Reg result = between;
  if (turned(in, *chain.back(), between)) {
    --links;
  } else {
    result = value_near(in, *first, {between, to.early || needs_own});
  }
  for (std::size_t i = links; i-- > 0;) {
    const Emitter::Mark mark = in.code.mark();
    const BinaryExpr& link = *chain[i];
    if (i > 0 && add_to_product(in, link, *chain[i - 1], result, i == 1 ? to.reg : between)) {
      --i;
    } else {
      arithmetic(in, {link.span, &link}, link.op, result, *link.right, i == 0 ? to.reg : between);
    }
    in.code.release(mark);
    result = i == 0 ? to.reg : between;
  }
}

// to = left op right. `to` is not written before the right side has been evaluated.
void arithmetic(Lowering& in, Site site, Op op, Reg left, const Expr& right, Reg to) {
  if (in.options.optimise) {
    if (multiply_add(in, site, op, left, right, to)) return;
    if (with_small(in, site, op, left, right, to) || by_power_of_two(in, site, op, left, right, to))
      return;
    if (with_int(in, site, op, left, right, to) || with_field(in, site, op, left, right, to))
      return;
    if (with_constant(in, site, op, left, right, to)) return;
    if (left == to && op == Op::kMulR && multiply_element(in, right, to)) return;
  }
  const Reg other = value(in, right);
  in.code.at(site.span, site.expr);
  in.code.emit(arithmetic_instruction(op), to, left, other);
}

// x + a * b as one instruction. The product is rounded, then the sum: the same bits as with two
// instructions.
static bool multiply_add(Lowering& in, Site site, Op op, Reg left, const Expr& right, Reg to) {
  if (op != Op::kAddR && (op != Op::kSubR || left != to)) return false;
  if (!is_product(right)) return false;
  const auto& product = right.as<BinaryExpr>();
  const Reg a = value(in, *product.left);
  if (left == to && op == Op::kAddR && add_product_of_element(in, site, a, *product.right, to)) {
    return true;
  }
  const Reg b = value(in, *product.right);
  in.code.at(site.span, site.expr);
  if (left == to) {
    in.code.emit(op == Op::kAddR ? OpCode::MADD : OpCode::MSUB, to, a, b);
  } else {
    in.code.emit(OpCode::MULADD, to, a, b);
    in.code.emit(OpCode::WITH, left);
  }
  return true;
}

// a * b + x where a register has x; `left` is the register of a.
static bool add_to_product(Lowering& in, const BinaryExpr& product, const BinaryExpr& sum, Reg left,
                           Reg to) {
  Reg added;
  if (!in.options.optimise || product.op != Op::kMulR || sum.op != Op::kAddR) return false;
  if (!in_register(in, *sum.right, added)) return false;
  const Reg factor = value(in, *product.right);
  in.code.at(sum.span, &sum);
  in.code.emit(OpCode::MULADD, to, left, factor);
  in.code.emit(OpCode::WITH, added);
  return true;
}

// x + i with an int i: one instruction converts and adds.
static bool with_int(Lowering& in, Site site, Op op, Reg left, const Expr& right, Reg to) {
  Slot known;
  const OpCode variant = variant_of(Variant::kWithInt, arithmetic_instruction(op));
  if (variant == kNoVariant || !is_from_int(right) || constant_slot(right, known)) return false;
  const Reg number = value(in, *right.as<ConvertExpr>().operand);
  in.code.at(site.span, site.expr);
  in.code.emit(variant, to, left, number);
  return true;
}

// x - xs[i].field as one instruction.
static bool with_field(Lowering& in, Site site, Op op, Reg left, const Expr& right, Reg to) {
  const OpCode variant = variant_of(Variant::kFieldOfElement, arithmetic_instruction(op));
  if (variant == kNoVariant || !is_field_of_element(right)) return false;
  if (may_be_unset(in, *right.as<FieldExpr>().object->type)) return false;
  const auto& element = right.as<FieldExpr>().object->as<ElementExpr>();
  const Reg list = borrow(in, *element.object, hold_over(in, *element.index));
  const Reg index = value(in, *element.index);
  in.code.at(element.span, &element);
  in.code.emit(variant, to, list, index);
  in.code.at(site.span, site.expr);
  in.code.push(OpCode::FACTORS, left.bits, left.bits, right.as<FieldExpr>().field);
  return true;
}

// 1.5 * x, 2 * i; i * x and xs[i].field * x with x in a register: the operands are exchanged, which
// does not change the result.
static bool turned(Lowering& in, const BinaryExpr& e, Reg to) {
  Reg right;
  std::int64_t small = 0;
  if (!in.options.optimise) return false;
  if ((e.op == Op::kAddI || e.op == Op::kMulI) && small_int(*e.left, small)) {
    return with_small(in, {e.span, &e}, e.op, value(in, *e.right), *e.left, to);
  }
  if (e.op != Op::kAddR && e.op != Op::kMulR) return false;
  Slot known;
  if (constant_slot(*e.left, known)) {
    return !in_register(in, *e.left, right) &&
           with_constant(in, {e.span, &e}, e.op, value(in, *e.right), *e.left, to);
  }
  if (!is_from_int(*e.left) && !is_field_of_element(*e.left)) return false;
  if (!in_register(in, *e.right, right)) return false;
  return with_int(in, {e.span, &e}, e.op, right, *e.left, to) ||
         with_field(in, {e.span, &e}, e.op, right, *e.left, to);
}

// x += a * xs[i] and x += a * rows[i][j], after a was evaluated.
static bool add_product_of_element(Lowering& in, Site site, Reg a, const Expr& b, Reg to) {
  if (b.kind != ExprKind::kElement || b.constant != nullptr) return false;
  const auto& element = b.as<ElementExpr>();
  if (element.column != nullptr) return false;
  const bool twice = element.object->kind == ExprKind::kElement && is_plain(*element.index);
  const auto& inner = twice ? element.object->as<ElementExpr>() : element;
  const Hold hold = hold_over(in, *inner.index);
  const Reg list = borrow(in, *inner.object, hold);
  const Reg i = value(in, *inner.index);
  const Reg j = twice ? value(in, *element.index) : Reg{};
  in.code.at(inner.span, &inner);
  in.code.emit(twice ? OpCode::MADDLDLD : OpCode::MADDLD, to, list, i);
  if (twice) {
    in.code.at(element.span, &element);
    in.code.emit(OpCode::PAIR, a, j);
  } else {
    in.code.at(site.span, site.expr);
    in.code.emit(OpCode::WITH, a);
  }
  return true;
}

static bool multiply_element(Lowering& in, const Expr& right, Reg accumulator) {
  if (right.kind != ExprKind::kElement || right.constant != nullptr) return false;
  const auto& element = right.as<ElementExpr>();
  if (element.column != nullptr) return false;
  const Reg list = borrow(in, *element.object, hold_over(in, *element.index));
  const Reg index = value(in, *element.index);
  in.code.at(right.span, &right);
  in.code.emit(OpCode::LDMUL, accumulator, list, index);
  return true;
}

static void truth_into(Lowering& in, const Expr& e, Dest to) {
  if (e.kind == ExprKind::kBinary && is_number_comparison(e.as<BinaryExpr>().op)) {
    const auto& binary = e.as<BinaryExpr>();
    const Reg left = value(in, *binary.left);
    const Reg right = value(in, *binary.right);
    const bool turned = is_turned(binary.op);
    in.code.at(e.span, &e);
    in.code.emit(arithmetic_instruction(binary.op), to.reg, turned ? right : left,
                 turned ? left : right);
    return;
  }
  const Label no = in.code.label();
  const Label end = in.code.label();
  branch(in, e, false, no);
  in.code.constant(to.reg, slot_of(true));
  in.code.jump(end);
  in.code.bind(no);
  in.code.constant(to.reg, slot_of(false));
  in.code.bind(end);
}

static void cond_into(Lowering& in, const CondExpr& e, Dest to) {
  const Label no = in.code.label();
  const Label end = in.code.label();
  branch(in, *e.condition, false, no);
  value_into(in, *e.yes, to);
  in.code.jump(end);
  in.code.bind(no);
  value_into(in, *e.no, to);
  in.code.bind(end);
}

static void convert_into(Lowering& in, const ConvertExpr& e, Dest to) {
  if (e.conversion == Conversion::kSame) {
    value_into(in, *e.operand, to);
    return;
  }
  const Reg operand = value_near(in, *e.operand, to);
  in.code.at(e.span, &e);
  in.code.emit(e.conversion == Conversion::kIntToReal ? OpCode::ITOR : OpCode::RTOI, to.reg,
               operand);
}

static void length_into(Lowering& in, const LengthExpr& e, Reg to) {
  const Reg object = borrow(in, *e.object, Hold::kNow);
  in.code.at(e.span, &e);
  const Type& type = *e.object->type;
  const OpCode length = type.is(Kind::kText)  ? OpCode::LENTEXT
                        : type.is(Kind::kMap) ? OpCode::MAPLEN
                                              : OpCode::LEN;
  in.code.emit(length, to, object);
}

// ---- fields and elements, also as borrowed references

void load_field(Lowering& in, const FieldExpr& e, Reg to, Hold hold) {
  if (in.options.optimise && e.object->kind == ExprKind::kElement &&
      !may_be_unset(in, *e.object->type)) {
    const auto& element = e.object->as<ElementExpr>();
    const Reg list = borrow(in, *element.object, stronger(hold, hold_over(in, *element.index)));
    const Reg index = value(in, *element.index);
    in.code.at(element.span, &element);
    in.code.emit(OpCode::LDF, to, list, index);
    in.code.word(e.field);
    return;
  }
  const Reg record = borrow(in, *e.object, hold);
  in.code.at(e.span, &e);
  in.code.push(OpCode::FLD, to.bits, record.bits, e.field);
}

// rows[i][j] as one instruction, if the evaluation of j cannot fail and runs no other code.
static bool load_element_twice(Lowering& in, const ElementExpr& e, Reg to, Hold hold) {
  if (!in.options.optimise || e.object->kind != ExprKind::kElement || !is_plain(*e.index))
    return false;
  const auto& row = e.object->as<ElementExpr>();
  const Reg rows = borrow(in, *row.object, stronger(hold, hold_over(in, *row.index)));
  const Reg i = value(in, *row.index);
  const Reg j = value(in, *e.index);
  in.code.at(row.span, &row);
  in.code.emit(OpCode::LDLD, to, rows, i);
  in.code.at(e.span, &e);
  in.code.emit(OpCode::WITH, j);
  return true;
}

void load_element(Lowering& in, const ElementExpr& e, Reg to, Hold hold) {
  if (e.column != nullptr) return load_matrix_element(in, e, to, hold);
  const bool may_fail = may_be_unset(in, *e.type);
  if (!may_fail && load_element_twice(in, e, to, hold)) return;
  const Reg list = borrow(in, *e.object, stronger(hold, hold_over(in, *e.index)));
  std::int64_t small = 0;
  if (in.options.optimise && !may_fail && small_int(*e.index, small)) {
    in.code.at(e.span, &e);
    in.code.push(OpCode::LDI, to.bits, list.bits, static_cast<std::uint16_t>(small));
    return;
  }
  const Reg index = value(in, *e.index);
  in.code.at(e.span, &e);
  in.code.emit(may_fail ? OpCode::LDSET : OpCode::LD, to, list, index);
}

}  // namespace armlet::lang
