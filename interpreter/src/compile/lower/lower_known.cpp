// Arithmetic with an operand that the text gives.

#include <bit>

#include "compile/lower/lowering.hpp"

namespace armlet::lang {

using namespace hir;

// i + 1, i - 1, i * 2
bool Lowering::with_small(Site site, Op op, Reg left, const Expr& right, Reg to) {
  std::int64_t small = 0;
  if ((op != Op::kAddI && op != Op::kSubI && op != Op::kMulI) || !small_int(right, small)) {
    return false;
  }
  if (op == Op::kSubI) small = -small;
  if (small > INT16_MAX) return false;
  code_.at(site.span, site.expr);
  code_.push(op == Op::kMulI ? OpCode::MULIK : OpCode::ADDIK, to.bits, left.bits,
             static_cast<std::uint16_t>(small));
  return true;
}

// x / 8, x % 8
bool Lowering::by_power_of_two(Site site, Op op, Reg left, const Expr& right, Reg to) {
  Slot known;
  if ((op != Op::kDivI && op != Op::kModI) || !constant_slot(right, known)) return false;
  if (known.i < 2 || !std::has_single_bit(static_cast<std::uint64_t>(known.i))) return false;
  const int power = std::countr_zero(static_cast<std::uint64_t>(known.i));
  code_.at(site.span, site.expr);
  code_.push(op == Op::kDivI ? OpCode::DIVP : OpCode::MODP, to.bits, left.bits,
             static_cast<std::uint32_t>(power));
  return true;
}

// x + 1.5, x - 1.5, x * 1.5 where the constant has no register: outside of loops.
bool Lowering::with_constant(Site site, Op op, Reg left, const Expr& right, Reg to) {
  Slot known;
  Reg loaded;
  if (op != Op::kAddR && op != Op::kSubR && op != Op::kMulR) return false;
  if (!constant_slot(right, known) || in_register(right, loaded)) return false;
  if (op == Op::kSubR) known.d = -known.d;
  code_.at(site.span, site.expr);
  if (op != Op::kMulR && left == to && code_.scale_and_offset(to, known)) return true;
  code_.with_constant(op == Op::kMulR ? OpCode::MULRK : OpCode::ADDRK, to, left, known);
  return true;
}

}  // namespace armlet::lang
