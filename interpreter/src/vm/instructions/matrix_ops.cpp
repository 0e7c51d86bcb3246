// Instructions that make matrices, and that read and change parts of them.

#include <algorithm>

#include "armlet/interpreter/work.hpp"
#include "vm/failures/failures.hpp"
#include "vm/instructions/slow_ops.hpp"

namespace armlet::lang {

namespace {

MatrixObj& matrix_in(Slot s) { return *static_cast<MatrixObj*>(s.o); }
ListObj& list_in(Slot s) { return *static_cast<ListObj*>(s.o); }

constexpr std::uint16_t kOneRow = 1;
constexpr std::uint16_t kOneColumn = 2;

// A rectangular part of a matrix.
struct Part {
  std::uint32_t row = 0;
  std::uint32_t rows = 0;
  std::uint32_t col = 0;
  std::uint32_t cols = 0;
};

bool read_ends(VmState& state, const Slot* ends, bool single, std::uint32_t size,
               std::string_view what, std::uint32_t& first, std::uint32_t& count) {
  if (single) {
    const std::int64_t index = ends[0].i;
    if (static_cast<std::uint64_t>(index) >= size) return raise_index(state, index, size, what);
    first = static_cast<std::uint32_t>(index);
    count = 1;
    return true;
  }
  std::uint32_t last = 0;
  if (!slice_ends(state, ends, size, what, first, last)) return false;
  count = last - first;
  return true;
}

bool read_part(VmState& state, const MatrixObj& matrix, const Slot* ends, std::uint16_t single,
               Part& part) {
  return read_ends(state, ends, (single & kOneRow) != 0, matrix.rows, "row", part.row, part.rows) &&
         read_ends(state, ends + 2, (single & kOneColumn) != 0, matrix.cols, "column", part.col,
                   part.cols);
}

std::string size_text(std::uint32_t rows, std::uint32_t cols) {
  return std::to_string(rows) + 'x' + std::to_string(cols);
}

// The count of operations for copying a row.
unsigned cost_of_row(std::uint32_t cols) { return 32U + 2U * std::min(cols, 100'000'000U); }

void put(VmState& state, Slot& place, Obj* object) {
  Obj* old = place.o;
  place.o = object;
  state.heap.release(old);
}

}  // namespace

bool raise_cell(VmState& state, const MatrixObj& matrix, std::int64_t row, std::int64_t column) {
  if (static_cast<std::uint64_t>(row) >= matrix.rows)
    return raise_index(state, row, matrix.rows, "row");
  return raise_index(state, column, matrix.cols, "column");
}

bool op_makemat(VmState& state, Slot* base, const Instr* pc) {
  const std::uint32_t cols = pc[1].b;
  MatrixObj* matrix = state.heap.new_matrix(pc->c / cols, cols);
  if (matrix == nullptr) return raise_out_of_memory(state);
  const Slot* from = base + pc->b;
  for (std::uint32_t i = 0; i < pc->c; ++i) matrix->data()[i] = from[i].d;
  put(state, base[pc->a], matrix);
  return true;
}

bool op_part(VmState& state, Slot* base, const Instr* pc) {
  const MatrixObj& from = matrix_in(base[pc->b]);
  Part part;
  if (!read_part(state, from, base + pc->c, pc[1].b, part)) return false;
  Obj* made = nullptr;
  double* to = nullptr;
  if (pc[1].b == 0) {
    MatrixObj* matrix = state.heap.new_matrix(part.rows, part.cols);
    if (matrix == nullptr) return raise_out_of_memory(state);
    made = matrix;
    to = matrix->data();
  } else {
    ListObj* list = state.heap.new_list_unset(std::uint64_t{part.rows} * part.cols, false);
    if (list == nullptr) return raise_out_of_memory(state);
    made = list;
    to = reinterpret_cast<double*>(list->data);
  }
  const auto copy = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double* row = from.data() + (part.row + i) * from.cols + part.col;
      to = std::copy(row, row + part.cols, to);
    }
  };
  if (!in_blocks(state.vm, part.rows, cost_of_row(part.cols), copy)) {
    state.heap.release(made);
    return false;
  }
  put(state, base[pc->a], made);
  return true;
}

bool op_putpart(VmState& state, Slot* base, const Instr* pc) {
  Slot& place = *reinterpret_cast<Slot*>(base[pc->a].o);
  if (!own(state, place)) return false;
  MatrixObj& matrix = matrix_in(place);
  Part part;
  if (!read_part(state, matrix, base + pc->b, pc[1].b, part)) return false;
  const Slot value = base[pc->c];
  const bool is_matrix = value.o->kind == ObjKind::kMatrix;
  const std::uint32_t count = is_matrix ? 0 : list_in(value).size;
  const bool fits = is_matrix
                        ? matrix_in(value).rows == part.rows && matrix_in(value).cols == part.cols
                        : count == std::uint64_t{part.rows} * part.cols;
  if (!fits) {
    const std::string given = is_matrix    ? size_text(matrix_in(value).rows, matrix_in(value).cols)
                              : count == 1 ? "1 value"
                                           : std::to_string(count) + " values";
    return raise(state, "R0613",
                 {"a part of " + size_text(part.rows, part.cols) + " is given " + given});
  }
  const double* from =
      is_matrix ? matrix_in(value).data() : reinterpret_cast<const double*>(list_in(value).data);
  return in_blocks(state.vm, part.rows, cost_of_row(part.cols),
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t i = begin; i < end; ++i) {
                       double* row = matrix.data() + (part.row + i) * matrix.cols + part.col;
                       std::copy(from, from + part.cols, row);
                       from += part.cols;
                     }
                   });
}

bool op_rowsof(VmState& state, Slot* base, const Instr* pc) {
  const MatrixObj& matrix = matrix_in(base[pc->b]);
  ListObj* rows = state.heap.new_list(matrix.rows, true);
  if (rows == nullptr) return raise_out_of_memory(state);
  const auto make = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      ListObj* row = state.heap.new_list_unset(matrix.cols, false);
      if (row == nullptr) return raise_out_of_memory(state);
      const double* from = matrix.data() + i * matrix.cols;
      std::copy(from, from + matrix.cols, reinterpret_cast<double*>(row->data));
      rows->data[i].o = row;
    }
    return true;
  };
  if (!in_blocks(state.vm, matrix.rows, cost_of_row(matrix.cols), make)) {
    state.heap.release(rows);
    return false;
  }
  put(state, base[pc->a], rows);
  return true;
}

}  // namespace armlet::lang
