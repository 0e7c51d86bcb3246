// Compiles matrices and the parts of matrices and lists.

#include <array>

#include "hir/walk.hpp"
#include "lower/places.hpp"
#include "lower/values.hpp"

namespace armlet::lang {

using namespace hir;

static Reg part_ends(Lowering& in, std::span<const PartEnds> ends);

namespace {

// The bits of the instructions PART and PUTPART that mark the index positions with a single index.
std::uint32_t single_places(const PartEnds& rows, const PartEnds& cols) {
  return (rows.is_range ? 0U : 1U) | (cols.is_range ? 0U : 2U);
}

}  // namespace

void make_matrix(Lowering& in, const MatrixExpr& e, Reg to) {
  const Reg base = in.code.number();
  window(in, e.items, base, Hold::kNow);
  in.code.at(e.span, &e);
  if (e.items.size() > UINT16_MAX) throw TooLarge{e.span, "values in one matrix", UINT16_MAX};
  in.code.push(OpCode::MAKEMAT, to.bits, base.bits, static_cast<std::uint32_t>(e.items.size()));
  in.code.word(e.cols);
}

// The bounds of a part in consecutive registers, two for each index position.
static Reg part_ends(Lowering& in, std::span<const PartEnds> ends) {
  Reg base;
  for (std::size_t i = 0; i < 2 * ends.size(); ++i) {
    const Reg reg = in.code.number();
    if (i == 0) base = reg;
  }
  for (std::uint32_t i = 0; i < ends.size(); ++i) {
    std::uint32_t at = 2 * i;
    for (const Expr* end : {ends[i].first, ends[i].last}) {
      const Reg reg = base.plus(at++);
      if (end != nullptr) {
        value_into(in, *end, {reg, true});
      } else {
        in.code.constant(reg, Slot{.i = kAbsentBits});
      }
    }
  }
  return base;
}

void make_part(Lowering& in, const PartExpr& e, Reg to) {
  Hold hold = Hold::kNow;
  const auto outlast = [&](const Expr& end) { hold = stronger(hold, hold_over(in, end)); };
  for_each_end(e.rows, outlast);
  for_each_end(e.cols, outlast);
  const Reg object = borrow(in, *e.object, hold);
  const Reg base = part_ends(in, std::array{e.rows, e.cols});
  in.code.at(e.span, &e);
  in.code.emit(OpCode::PART, to, object, base);
  in.code.word(single_places(e.rows, e.cols));
}

void load_matrix_element(Lowering& in, const ElementExpr& e, Reg to, Hold hold) {
  hold = stronger(hold, stronger(hold_over(in, *e.index), hold_over(in, *e.column)));
  const Reg matrix = borrow(in, *e.object, hold);
  const Reg row = value(in, *e.index);
  const Reg column = value(in, *e.column);
  in.code.at(e.span, &e);
  in.code.emit(OpCode::LDM, to, matrix, row);
  in.code.emit(OpCode::WITH, column);
}

// The order of evaluation is that of elements: the bounds, then the value, then the steps to the
// assignment target.
void store_part(Lowering& in, const StorePartStmt& s) {
  const Emitter::Mark mark = in.code.mark();
  in.code.at(s.span);
  check_set(in, *s.place.variable);
  const Indices indices = index_values(in, s.place);
  const bool list = s.place.type->is(Kind::kList);
  const Reg base =
      list ? part_ends(in, std::array{s.rows}) : part_ends(in, std::array{s.rows, s.cols});
  const Reg from = borrow(in, *s.value, hold_for(s.place, *s.value));
  check_whole(in, *s.value, from, true);
  const Reg to = address(in, s.place, indices);
  in.code.at(s.span);
  in.code.emit(list ? OpCode::PUTSLICE : OpCode::PUTPART, to, base, from);
  if (!list) in.code.word(single_places(s.rows, s.cols));
  in.code.release(mark);
}

}  // namespace armlet::lang
