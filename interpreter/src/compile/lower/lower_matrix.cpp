// Matrices and the parts of matrices and lists.

#include <array>

#include "check/tree/walk.hpp"
#include "compile/lower/lowering.hpp"

namespace armlet::lang {

using namespace hir;

namespace {

// Which places are single indices, as PART and PUTPART read it.
std::uint32_t single_places(const PartEnds& rows, const PartEnds& cols) {
  return (rows.is_range ? 0U : 1U) | (cols.is_range ? 0U : 2U);
}

}  // namespace

void Lowering::make_matrix(const MatrixExpr& e, Reg to) {
  const Reg base = code_.number();
  window(e.items, base, Hold::kNow);
  code_.at(e.span, &e);
  if (e.items.size() > UINT16_MAX) throw TooLarge{e.span, "values in one matrix", UINT16_MAX};
  code_.push(OpCode::MAKEMAT, to.bits, base.bits, static_cast<std::uint32_t>(e.items.size()));
  code_.word(e.cols);
}

// The ends in consecutive registers, two for each place between the brackets.
Reg Lowering::part_ends(std::span<const PartEnds> ends) {
  Reg base;
  for (std::size_t i = 0; i < 2 * ends.size(); ++i) {
    const Reg reg = code_.number();
    if (i == 0) base = reg;
  }
  for (std::uint32_t i = 0; i < ends.size(); ++i) {
    std::uint32_t at = 2 * i;
    for (const Expr* end : {ends[i].first, ends[i].last}) {
      const Reg reg = base.plus(at++);
      if (end != nullptr) {
        value_into(*end, {reg, true});
      } else {
        code_.constant(reg, Slot{.i = kAbsentBits});
      }
    }
  }
  return base;
}

void Lowering::make_part(const PartExpr& e, Reg to) {
  Hold hold = Hold::kNow;
  const auto outlast = [&](const Expr& end) { hold = stronger(hold, hold_over(end)); };
  for_each_end(e.rows, outlast);
  for_each_end(e.cols, outlast);
  const Reg object = borrow(*e.object, hold);
  const Reg base = part_ends(std::array{e.rows, e.cols});
  code_.at(e.span, &e);
  code_.emit(OpCode::PART, to, object, base);
  code_.word(single_places(e.rows, e.cols));
}

void Lowering::load_matrix_element(const ElementExpr& e, Reg to, Hold hold) {
  hold = stronger(hold, stronger(hold_over(*e.index), hold_over(*e.column)));
  const Reg matrix = borrow(*e.object, hold);
  const Reg row = value(*e.index);
  const Reg column = value(*e.column);
  code_.at(e.span, &e);
  code_.emit(OpCode::LDM, to, matrix, row);
  code_.emit(OpCode::WITH, column);
}

// As for elements: first what stands in the brackets, then the value, then the way to the place.
void Lowering::store_part(const StorePartStmt& s) {
  const Emitter::Mark mark = code_.mark();
  code_.at(s.span);
  check_set(*s.place.variable);
  const Indices indices = index_values(s.place);
  const bool list = s.place.type->is(Kind::kList);
  const Reg base = list ? part_ends(std::array{s.rows}) : part_ends(std::array{s.rows, s.cols});
  const Reg from = borrow(*s.value, hold_for(s.place, *s.value));
  check_whole(*s.value, from, true);
  const Reg to = address(s.place, indices);
  code_.at(s.span);
  code_.emit(list ? OpCode::PUTSLICE : OpCode::PUTPART, to, base, from);
  if (!list) code_.word(single_places(s.rows, s.cols));
  code_.release(mark);
}

}  // namespace armlet::lang
