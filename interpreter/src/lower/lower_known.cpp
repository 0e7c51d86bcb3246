// The instructions of operators, and arithmetic with one constant operand.

#include <bit>
#include <iterator>
#include <stdexcept>

#include "lower/values.hpp"

namespace armlet::lang {

using namespace hir;

namespace {

// Operators that have an instruction, in the order of the instructions.
struct Operator {
  Op op;
  OpCode instruction;
};
constexpr Operator kOperators[] = {
    {Op::kAddI, OpCode::ADDI}, {Op::kSubI, OpCode::SUBI}, {Op::kMulI, OpCode::MULI},
    {Op::kDivI, OpCode::DIVI}, {Op::kModI, OpCode::MODI}, {Op::kPowI, OpCode::POWI},
    {Op::kNegI, OpCode::NEGI}, {Op::kAddR, OpCode::ADDR}, {Op::kSubR, OpCode::SUBR},
    {Op::kMulR, OpCode::MULR}, {Op::kDivR, OpCode::DIVR}, {Op::kModR, OpCode::MODR},
    {Op::kPowR, OpCode::POWR}, {Op::kNegR, OpCode::NEGR}, {Op::kLtI, OpCode::LTI},
    {Op::kLeI, OpCode::LEI},   {Op::kGtI, OpCode::LTI},   {Op::kGeI, OpCode::LEI},
    {Op::kEqI, OpCode::EQI},   {Op::kNeI, OpCode::NEI},   {Op::kLtR, OpCode::LTR},
    {Op::kLeR, OpCode::LER},   {Op::kGtR, OpCode::LTR},   {Op::kGeR, OpCode::LER},
    {Op::kEqR, OpCode::EQR},   {Op::kNeR, OpCode::NER},   {Op::kNot, OpCode::NOT},
};
static_assert(
    [] {
      for (std::size_t i = 0; i < std::size(kOperators); ++i) {
        if (static_cast<std::size_t>(kOperators[i].op) != i) return false;
      }
      return std::size(kOperators) == static_cast<std::size_t>(Op::kEqText);
    }(),
    "the operators on texts and objects follow");

}  // namespace

OpCode arithmetic_instruction(Op op) {
  const auto at = static_cast<std::size_t>(op);
  if (at >= std::size(kOperators)) throw std::logic_error("no instruction of its own");
  return kOperators[at].instruction;
}

// i + 1, i - 1, i * 2
bool with_small(Lowering& in, Site site, Op op, Reg left, const Expr& right, Reg to) {
  std::int64_t small = 0;
  const OpCode variant =
      variant_of(Variant::kSmall, arithmetic_instruction(op == Op::kSubI ? Op::kAddI : op));
  if (variant == kNoVariant || !small_int(right, small)) return false;
  if (op == Op::kSubI) small = -small;
  if (small > INT16_MAX) return false;
  in.code.at(site.span, site.expr);
  in.code.push(variant, to.bits, left.bits, static_cast<std::uint16_t>(small));
  return true;
}

// x / 8, x % 8
bool by_power_of_two(Lowering& in, Site site, Op op, Reg left, const Expr& right, Reg to) {
  Slot known;
  if ((op != Op::kDivI && op != Op::kModI) || !constant_slot(right, known)) return false;
  if (known.i < 2 || !std::has_single_bit(static_cast<std::uint64_t>(known.i))) return false;
  const int power = std::countr_zero(static_cast<std::uint64_t>(known.i));
  in.code.at(site.span, site.expr);
  in.code.push(op == Op::kDivI ? OpCode::DIVP : OpCode::MODP, to.bits, left.bits,
               static_cast<std::uint32_t>(power));
  return true;
}

// x + 1.5, x - 1.5, x * 1.5 outside of loops, where constants have no register.
bool with_constant(Lowering& in, Site site, Op op, Reg left, const Expr& right, Reg to) {
  Slot known;
  Reg loaded;
  const OpCode variant =
      variant_of(Variant::kWithConstant, arithmetic_instruction(op == Op::kSubR ? Op::kAddR : op));
  if (variant == kNoVariant) return false;
  if (!constant_slot(right, known) || in_register(in, right, loaded)) return false;
  if (op == Op::kSubR) known.d = -known.d;
  in.code.at(site.span, site.expr);
  if (op != Op::kMulR && left == to && in.code.scale_and_offset(to, known)) return true;
  in.code.with_constant(variant, to, left, known);
  return true;
}

}  // namespace armlet::lang
