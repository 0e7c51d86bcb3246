// Conditions that decide where to go on.

#include "compile/lower/lowering.hpp"

namespace armlet::lang {

using namespace hir;

namespace {

// The comparison that is true when `op` is false; for ints.
Op negated(Op op) {
  switch (op) {
    case Op::kLtI:
      return Op::kGeI;
    case Op::kLeI:
      return Op::kGtI;
    case Op::kGtI:
      return Op::kLeI;
    case Op::kGeI:
      return Op::kLtI;
    case Op::kEqI:
      return Op::kNeI;
    default:
      return Op::kEqI;
  }
}

OpCode compare(Op op) {
  switch (op) {
    case Op::kLtI:
      return OpCode::IFLTI;
    case Op::kLeI:
      return OpCode::IFLEI;
    case Op::kGtI:
      return OpCode::IFGTI;
    case Op::kGeI:
      return OpCode::IFGEI;
    case Op::kEqI:
      return OpCode::IFEQI;
    default:
      return OpCode::IFNEI;
  }
}

OpCode compare_small(Op op) {
  switch (op) {
    case Op::kLtI:
      return OpCode::IFLTIK;
    case Op::kLeI:
      return OpCode::IFLEIK;
    case Op::kGtI:
      return OpCode::IFGTIK;
    case Op::kGeI:
      return OpCode::IFGEIK;
    case Op::kEqI:
      return OpCode::IFEQIK;
    default:
      return OpCode::IFNEIK;
  }
}

// Texts are compared by the sign of CMPTEXT.
Op sign_test(Op op) {
  switch (op) {
    case Op::kEqText:
      return Op::kEqI;
    case Op::kNeText:
      return Op::kNeI;
    case Op::kLtText:
      return Op::kLtI;
    case Op::kLeText:
      return Op::kLeI;
    case Op::kGtText:
      return Op::kGtI;
    default:
      return Op::kGeI;
  }
}

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
  switch (e.op) {
    case Op::kLtI:
    case Op::kLeI:
    case Op::kGtI:
    case Op::kGeI:
    case Op::kEqI:
    case Op::kNeI:
      branch_int(e, when ? e.op : negated(e.op), to);
      return true;
    case Op::kLtR:
    case Op::kLeR:
    case Op::kGtR:
    case Op::kGeR:
    case Op::kEqR:
    case Op::kNeR:
      branch_real(e, when, to);
      return true;
    case Op::kEqText:
    case Op::kNeText:
    case Op::kLtText:
    case Op::kLeText:
    case Op::kGtText:
    case Op::kGeText: {
      const Op op = sign_test(e.op);
      branch_text(e, when ? op : negated(op), to);
      return true;
    }
    case Op::kEqDeep:
      branch_deep(e, when, to);
      return true;
    case Op::kNeDeep:
      branch_deep(e, !when, to);
      return true;
    default:
      return false;
  }
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

// Not (a < b) differs from a >= b when one of them is not a number.
void Lowering::branch_real(const BinaryExpr& e, bool when, Label to) {
  const Emitter::Mark mark = code_.mark();
  const Reg left = value(*e.left);
  const Reg right = value(*e.right);
  code_.release(mark);
  code_.at(e.span, &e);
  switch (e.op) {
    case Op::kLtR:
      code_.emit(when ? OpCode::IFLTR : OpCode::IFNLTR, left, right);
      break;
    case Op::kLeR:
      code_.emit(when ? OpCode::IFLER : OpCode::IFNLER, left, right);
      break;
    case Op::kGtR:
      code_.emit(when ? OpCode::IFLTR : OpCode::IFNLTR, right, left);
      break;
    case Op::kGeR:
      code_.emit(when ? OpCode::IFLER : OpCode::IFNLER, right, left);
      break;
    case Op::kEqR:
      code_.emit(when ? OpCode::IFEQR : OpCode::IFNER, left, right);
      break;
    default:
      code_.emit(when ? OpCode::IFNER : OpCode::IFEQR, left, right);
      break;
  }
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
