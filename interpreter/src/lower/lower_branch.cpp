// Compiles conditions to branches.

#include "lower/statements.hpp"
#include "lower/values.hpp"

namespace armlet::lang {

using namespace hir;

static void branch_on(Lowering& in, Reg truth, bool when, Label to);
static void branch_all(Lowering& in, const BinaryExpr& e, bool when, Label to);
static bool branch_compare(Lowering& in, const BinaryExpr& e, bool when, Label to);
static void branch_int(Lowering& in, const BinaryExpr& e, Op op, Label to);
static void branch_real(Lowering& in, const BinaryExpr& e, bool when, Label to);
static bool branch_characters(Lowering& in, const BinaryExpr& e, Op op, Label to);
static void branch_text(Lowering& in, const BinaryExpr& e, Op op, Label to);
static void branch_deep(Lowering& in, const BinaryExpr& e, bool equal, Label to);

namespace {

// The instructions of comparisons of ints, in the order of the operators.
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

// The instructions of comparisons of doubles. With NaN, not (a < b) differs from a >= b.
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

// The tests of comparisons of texts, which use the sign that CMPTEXT computes.
struct TextTest {
  Op op;
  Op sign;
};
constexpr TextTest kTextTests[] = {
    {Op::kEqText, Op::kEqI}, {Op::kNeText, Op::kNeI}, {Op::kLtText, Op::kLtI},
    {Op::kLeText, Op::kLeI}, {Op::kGtText, Op::kGtI}, {Op::kGeText, Op::kGeI},
};

// The row of an operator; null if there is none.
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

// Jumps to `to` if the condition equals `when`; otherwise the next instruction follows.
void branch(Lowering& in, const Expr& e, bool when, Label to) {
  Slot slot;
  if (constant_slot(e, slot)) {
    if ((slot.i != 0) == when) in.code.jump(to);
    return;
  }
  if (e.kind == ExprKind::kAnd || e.kind == ExprKind::kOr) {
    branch_all(in, e.as<BinaryExpr>(), when, to);
    return;
  }
  if (e.kind == ExprKind::kUnary && e.as<UnaryExpr>().op == Op::kNot) {
    branch(in, *e.as<UnaryExpr>().operand, !when, to);
    return;
  }
  if (e.kind == ExprKind::kBinary && branch_compare(in, e.as<BinaryExpr>(), when, to)) return;
  const Emitter::Mark mark = in.code.mark();
  const Reg truth = value(in, e);
  in.code.release(mark);
  in.code.at(e.span, &e);
  branch_on(in, truth, when, to);
}

static void branch_on(Lowering& in, Reg truth, bool when, Label to) {
  if (!in.code.is_bound(to)) {
    in.code.jump_if(when ? OpCode::JT : OpCode::JF, truth, to);
    return;
  }
  in.code.push(when ? OpCode::IFNEIK : OpCode::IFEQIK, truth.bits, 0, 0);
  in.code.jump(to);
}

// Compiles a && b && c from the innermost left operand on; likewise ||.
static void branch_all(Lowering& in, const BinaryExpr& e, bool when, Label to) {
  std::vector<const Expr*> parts;
  const Expr* first = &e;
  for (; first->kind == e.kind && first->constant == nullptr;
       first = first->as<BinaryExpr>().left) {
    parts.push_back(first->as<BinaryExpr>().right);
  }
  parts.push_back(first);
  // The value of one operand that decides the whole: false for &&, true for ||.
  const bool deciding = e.kind == ExprKind::kOr;
  const Label skip = in.code.label();
  for (std::size_t i = parts.size(); i-- > 0;) {
    if (when == deciding || i == 0) {
      branch(in, *parts[i], when, to);
    } else {
      branch(in, *parts[i], deciding, skip);
    }
  }
  in.code.bind(skip);
}

static bool branch_compare(Lowering& in, const BinaryExpr& e, bool when, Label to) {
  const auto asked = [&](Op op) { return when ? op : row_of(kIntTests, op)->negated; };
  if (row_of(kIntTests, e.op) != nullptr) {
    branch_int(in, e, asked(e.op), to);
  } else if (row_of(kRealTests, e.op) != nullptr) {
    branch_real(in, e, when, to);
  } else if (const TextTest* text = row_of(kTextTests, e.op); text != nullptr) {
    branch_text(in, e, asked(text->sign), to);
  } else if (e.op == Op::kEqDeep || e.op == Op::kNeDeep) {
    branch_deep(in, e, when == (e.op == Op::kEqDeep), to);
  } else {
    return false;
  }
  return true;
}

static void branch_int(Lowering& in, const BinaryExpr& e, Op op, Label to) {
  const Emitter::Mark mark = in.code.mark();
  const Reg left = value(in, *e.left);
  std::int64_t small = 0;
  const bool counts =
      in.options.optimise && (op == Op::kLtI || op == Op::kGeI) && in.code.just_counted(left);
  if (in.options.optimise && !counts && small_int(*e.right, small)) {
    in.code.release(mark);
    in.code.at(e.span, &e);
    in.code.push(compare_small(op), left.bits, static_cast<std::uint16_t>(small), 0);
  } else {
    const Reg right = value(in, *e.right);
    in.code.release(mark);
    in.code.at(e.span, &e);
    if (counts) {
      in.code.count_and_compare(op == Op::kLtI, left, right);
    } else {
      in.code.emit(compare(op), left, right);
    }
  }
  in.code.jump(to);
}

static void branch_real(Lowering& in, const BinaryExpr& e, bool when, Label to) {
  const RealTest& row = *row_of(kRealTests, e.op);
  const Emitter::Mark mark = in.code.mark();
  const Reg left = value(in, *e.left);
  const Reg right = value(in, *e.right);
  in.code.release(mark);
  in.code.at(e.span, &e);
  in.code.emit(when ? row.test : row.otherwise, row.turned ? right : left,
               row.turned ? left : right);
  in.code.jump(to);
}

namespace {

// The code of a constant text of one character.
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

// text[i] == "x" and text[i] == text[j] compare character codes, without making texts.
static bool branch_characters(Lowering& in, const BinaryExpr& e, Op op, Label to) {
  std::int64_t code = 0;
  const bool with_known = is_character(*e.left) && known_character(*e.right, code);
  if (!in.options.optimise || (op != Op::kEqI && op != Op::kNeI)) return false;
  if (!with_known && !(is_character(*e.left) && is_character(*e.right))) return false;
  const Emitter::Mark mark = in.code.mark();
  const Reg left = in.code.number();
  character_code(in, e.left->as<CharacterExpr>(), left);
  if (with_known) {
    in.code.release(mark);
    in.code.at(e.span, &e);
    in.code.push(compare_small(op), left.bits, static_cast<std::uint16_t>(code), 0);
  } else {
    const Reg right = in.code.number();
    character_code(in, e.right->as<CharacterExpr>(), right);
    in.code.release(mark);
    in.code.at(e.span, &e);
    in.code.emit(compare(op), left, right);
  }
  in.code.jump(to);
  return true;
}

static void branch_text(Lowering& in, const BinaryExpr& e, Op op, Label to) {
  if (branch_characters(in, e, op, to)) return;
  const Emitter::Mark mark = in.code.mark();
  const Reg sign = in.code.number();
  const Reg left = borrow(in, *e.left, hold_over(in, *e.right));
  const Reg right = borrow(in, *e.right, Hold::kNow);
  in.code.at(e.span, &e);
  in.code.emit(OpCode::CMPTEXT, sign, left, right);
  in.code.release(mark);
  in.code.push(compare_small(op), sign.bits, 0, 0);
  in.code.jump(to);
}

static void branch_deep(Lowering& in, const BinaryExpr& e, bool equal, Label to) {
  const Emitter::Mark mark = in.code.mark();
  const Reg truth = in.code.number();
  const Reg left = borrow(in, *e.left, hold_over(in, *e.right));
  const Reg right = borrow(in, *e.right, Hold::kNow);
  check_whole(in, *e.left, left);
  check_whole(in, *e.right, right);
  in.code.at(e.span, &e);
  in.code.emit(OpCode::EQDEEP, truth, left, right);
  in.code.word(in.code.type(e.left->type));
  in.code.release(mark);
  branch_on(in, truth, equal, to);
}

}  // namespace armlet::lang
