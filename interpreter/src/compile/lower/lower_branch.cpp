// Conditions that decide where to go on.

#include "compile/lower/lowering.hpp"

namespace armlet::lang {

using namespace hir;

namespace {

// Comparisons of ints, in the order of their operators.
struct IntTest {
  Op op;
  Op negated;
  OpCode test;
};
constexpr IntTest kIntTests[] = {
    {Op::kLtI, Op::kGeI, OpCode::IFLTI}, {Op::kLeI, Op::kGtI, OpCode::IFLEI},
    {Op::kGtI, Op::kLeI, OpCode::IFGTI}, {Op::kGeI, Op::kLtI, OpCode::IFGEI},
    {Op::kEqI, Op::kNeI, OpCode::IFEQI}, {Op::kNeI, Op::kEqI, OpCode::IFNEI},
};

// Of doubles: not (a < b) differs from a >= b when one of them is not a number.
struct RealTest {
  Op op;
  OpCode test;
  OpCode otherwise;
  bool turned;
};
constexpr RealTest kRealTests[] = {
    {Op::kLtR, OpCode::IFLTR, OpCode::IFNLTR, false},
    {Op::kLeR, OpCode::IFLER, OpCode::IFNLER, false},
    {Op::kGtR, OpCode::IFLTR, OpCode::IFNLTR, true},
    {Op::kGeR, OpCode::IFLER, OpCode::IFNLER, true},
    {Op::kEqR, OpCode::IFEQR, OpCode::IFNER, false},
    {Op::kNeR, OpCode::IFNER, OpCode::IFEQR, false},
};

// Of texts, by the sign of CMPTEXT.
struct TextTest {
  Op op;
  Op sign;
};
constexpr TextTest kTextTests[] = {
    {Op::kEqText, Op::kEqI}, {Op::kNeText, Op::kNeI}, {Op::kLtText, Op::kLtI},
    {Op::kLeText, Op::kLeI}, {Op::kGtText, Op::kGtI}, {Op::kGeText, Op::kGeI},
};

// The row of an operator; null: there is none.
template <class Row, std::size_t n>
constexpr const Row* row_of(const Row (&table)[n], Op op) {
  const auto at = static_cast<std::size_t>(op) - static_cast<std::size_t>(table[0].op);
  return at < n ? &table[at] : nullptr;
}
template <class Row, std::size_t n>
constexpr bool is_in_order(const Row (&table)[n]) {
  for (const Row& row : table) {
    if (row_of(table, row.op) != &row) return false;
  }
  return true;
}
static_assert(is_in_order(kIntTests) && is_in_order(kRealTests) && is_in_order(kTextTests));

OpCode compare(Op op) { return row_of(kIntTests, op)->test; }
OpCode compare_small(Op op) { return variant_of(Variant::kSmall, compare(op)); }

}  // namespace

// Goes to `to` if the condition is `when`, else on to the next instruction.
void Lowering::branch(const Expr& e, bool when, Label to) {
  Slot slot;
  if (constant_slot(e, slot)) {
    if ((slot.i != 0) == when) code_.jump(to);
    return;
  }
  if (e.kind == ExprKind::kAnd || e.kind == ExprKind::kOr) {
    branch_all(e.as<BinaryExpr>(), when, to);
    return;
  }
  if (e.kind == ExprKind::kUnary && e.as<UnaryExpr>().op == Op::kNot) {
    branch(*e.as<UnaryExpr>().operand, !when, to);
    return;
  }
  if (e.kind == ExprKind::kBinary && branch_compare(e.as<BinaryExpr>(), when, to)) return;
  const Emitter::Mark mark = code_.mark();
  const Reg truth = value(e);
  code_.release(mark);
  code_.at(e.span, &e);
  branch_on(truth, when, to);
}

void Lowering::branch_on(Reg truth, bool when, Label to) {
  if (!code_.is_bound(to)) {
    code_.jump_if(when ? OpCode::JT : OpCode::JF, truth, to);
    return;
  }
  code_.push(when ? OpCode::IFNEIK : OpCode::IFEQIK, truth.bits, 0, 0);
  code_.jump(to);
}

// a && b && c from the innermost on the left; likewise ||.
void Lowering::branch_all(const BinaryExpr& e, bool when, Label to) {
  std::vector<const Expr*> parts;
  const Expr* first = &e;
  for (; first->kind == e.kind && first->constant == nullptr;
       first = first->as<BinaryExpr>().left) {
    parts.push_back(first->as<BinaryExpr>().right);
  }
  parts.push_back(first);
  // What makes a part decide the whole: false for &&, true for ||.
  const bool deciding = e.kind == ExprKind::kOr;
  const Label skip = code_.label();
  for (std::size_t i = parts.size(); i-- > 0;) {
    if (when == deciding || i == 0) {
      branch(*parts[i], when, to);
    } else {
      branch(*parts[i], deciding, skip);
    }
  }
  code_.bind(skip);
}

bool Lowering::branch_compare(const BinaryExpr& e, bool when, Label to) {
  const auto asked = [&](Op op) { return when ? op : row_of(kIntTests, op)->negated; };
  if (row_of(kIntTests, e.op) != nullptr) {
    branch_int(e, asked(e.op), to);
  } else if (row_of(kRealTests, e.op) != nullptr) {
    branch_real(e, when, to);
  } else if (const TextTest* text = row_of(kTextTests, e.op); text != nullptr) {
    branch_text(e, asked(text->sign), to);
  } else if (e.op == Op::kEqDeep || e.op == Op::kNeDeep) {
    branch_deep(e, when == (e.op == Op::kEqDeep), to);
  } else {
    return false;
  }
  return true;
}

void Lowering::branch_int(const BinaryExpr& e, Op op, Label to) {
  const Emitter::Mark mark = code_.mark();
  const Reg left = value(*e.left);
  std::int64_t small = 0;
  const bool counts =
      options_.optimise && (op == Op::kLtI || op == Op::kGeI) && code_.just_counted(left);
  if (options_.optimise && !counts && small_int(*e.right, small)) {
    code_.release(mark);
    code_.at(e.span, &e);
    code_.push(compare_small(op), left.bits, static_cast<std::uint16_t>(small), 0);
  } else {
    const Reg right = value(*e.right);
    code_.release(mark);
    code_.at(e.span, &e);
    if (counts) {
      code_.count_and_compare(op == Op::kLtI, left, right);
    } else {
      code_.emit(compare(op), left, right);
    }
  }
  code_.jump(to);
}

void Lowering::branch_real(const BinaryExpr& e, bool when, Label to) {
  const RealTest& row = *row_of(kRealTests, e.op);
  const Emitter::Mark mark = code_.mark();
  const Reg left = value(*e.left);
  const Reg right = value(*e.right);
  code_.release(mark);
  code_.at(e.span, &e);
  code_.emit(when ? row.test : row.otherwise, row.turned ? right : left, row.turned ? left : right);
  code_.jump(to);
}

namespace {

// The number of a text of one character that is known.
bool known_character(const Expr& e, std::int64_t& code) {
  std::string_view text;
  if (e.kind == ExprKind::kText) {
    text = e.as<TextExpr>().value;
  } else if (e.constant != nullptr && e.constant->kind == Constant::Kind::kText) {
    text = e.constant->text;
  }
  if (text.size() != 1 || static_cast<unsigned char>(text[0]) >= 0x80U) return false;
  code = text[0];
  return true;
}

bool is_character(const Expr& e) { return e.kind == ExprKind::kCharacter && e.constant == nullptr; }

}  // namespace

// text[i] == "x", text[i] == text[j]: the numbers of the characters are compared.
bool Lowering::branch_characters(const BinaryExpr& e, Op op, Label to) {
  std::int64_t code = 0;
  const bool with_known = is_character(*e.left) && known_character(*e.right, code);
  if (!options_.optimise || (op != Op::kEqI && op != Op::kNeI)) return false;
  if (!with_known && !(is_character(*e.left) && is_character(*e.right))) return false;
  const Emitter::Mark mark = code_.mark();
  const Reg left = code_.number();
  character_code(e.left->as<CharacterExpr>(), left);
  if (with_known) {
    code_.release(mark);
    code_.at(e.span, &e);
    code_.push(compare_small(op), left.bits, static_cast<std::uint16_t>(code), 0);
  } else {
    const Reg right = code_.number();
    character_code(e.right->as<CharacterExpr>(), right);
    code_.release(mark);
    code_.at(e.span, &e);
    code_.emit(compare(op), left, right);
  }
  code_.jump(to);
  return true;
}

void Lowering::branch_text(const BinaryExpr& e, Op op, Label to) {
  if (branch_characters(e, op, to)) return;
  const Emitter::Mark mark = code_.mark();
  const Reg sign = code_.number();
  const Reg left = borrow(*e.left, hold_over(*e.right));
  const Reg right = borrow(*e.right, Hold::kNow);
  code_.at(e.span, &e);
  code_.emit(OpCode::CMPTEXT, sign, left, right);
  code_.release(mark);
  code_.push(compare_small(op), sign.bits, 0, 0);
  code_.jump(to);
}

void Lowering::branch_deep(const BinaryExpr& e, bool equal, Label to) {
  const Emitter::Mark mark = code_.mark();
  const Reg truth = code_.number();
  const Reg left = borrow(*e.left, hold_over(*e.right));
  const Reg right = borrow(*e.right, Hold::kNow);
  check_whole(*e.left, left);
  check_whole(*e.right, right);
  code_.at(e.span, &e);
  code_.emit(OpCode::EQDEEP, truth, left, right);
  code_.word(code_.type(e.left->type));
  code_.release(mark);
  branch_on(truth, equal, to);
}

}  // namespace armlet::lang
