// Tables that functions of the host create.

#include "armlet/interpreter/host/table_text.hpp"
#include "armlet/interpreter/host/vm.hpp"
#include "armlet/interpreter/work.hpp"
#include "vm/instructions/slow_ops.hpp"
#include "vm/state/state.hpp"

namespace armlet {
namespace {

// The type that the checker made for a table with these columns; no type is added at run time.
const Type* table_type_of(Vm& vm, std::span<const TableColumn> columns) {
  TypePool& types = *vm.program().compiled().types;
  std::vector<RecordField> row;
  for (const TableColumn& column : columns) {
    row.push_back({.name = column.name,
                   .type = column.is_text         ? types.text()
                           : column.dim.is_none() ? types.real()
                                                  : types.quantity(column.dim)});
  }
  return types.table(std::move(row));
}

// Returns null, with the failure set, if the row cannot be made.
RecordObj* new_row(Vm& vm, const Type& row, const TableText& table, std::size_t at) {
  RecordObj* out = new_record(vm, &row);
  for (std::size_t i = 0; out != nullptr && i < table.columns.size(); ++i) {
    const TableColumn& column = table.columns[i];
    Slot& cell = out->fields()[i];
    if (!column.is_text) {
      cell.d = column.numbers[at];
      continue;
    }
    cell.o = new_text(vm, column.texts[at]);
    if (cell.o != nullptr) continue;
    release(vm, out);
    return nullptr;
  }
  return out;
}

}  // namespace

RecordObj* new_table(Vm& vm, const TableText& table) {
  const Type* type = table_type_of(vm, table.columns);
  ListMaker rows(vm);
  const auto add = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!rows.push(new_row(vm, *type->record->row, table, i))) return false;
    }
    return true;
  };
  const auto cost = static_cast<unsigned>(64 + 32 * table.columns.size());
  if (!in_blocks(vm, table.rows, cost, add)) return nullptr;
  Obj* list = rows.take();
  RecordObj* out = list != nullptr ? new_record(vm, type) : nullptr;
  if (out != nullptr) {
    out->fields()[type->record->fields.size()].o = list;
  } else if (list != nullptr) {
    release(vm, list);
  }
  return out;
}

}  // namespace armlet
