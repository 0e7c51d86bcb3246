#pragma once
// Tables as text: lines of cells with names above them, as spreadsheets write them.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/native.hpp"
#include "armlet/interpreter/unit.hpp"

namespace armlet {

// How the names of files with tables end.
inline constexpr std::string_view kTableEnding = ".csv";

// A column of numbers, or of texts.
//
// name  one that programs can write: "q1".
// unit  as it is written in brackets, "deg"; empty: plain numbers.
struct TableColumn {
  std::string name;
  std::string unit{};
  Dim dim{};
  bool is_text = false;
  std::vector<double> numbers{};  // SI
  std::vector<std::string> texts{};
};

// All columns have as many cells.
struct TableText {
  std::vector<TableColumn> columns;
  std::size_t rows = 0;
};

// Reads comma-separated values (RFC 4180); semicolons or tabulators separate them if the first line
// has such. The first line has the names, with a unit in brackets if any: `q1 [deg]`. What cannot
// be in a name becomes `_`. A column is of numbers if it has a unit or its first cell is a number
// without quotes, otherwise of texts. A byte order mark, ends of lines of any kind and empty lines
// at the end do not matter.
//
// returns  the table, or what is wrong, with the line and the column: a cell that is missing, that
//          is no number, or that has a decimal comma; a line with another number of cells.
[[nodiscard]] Result<TableText> read_table_text(std::string_view text);

// "t [s], q1 [deg], part: string": the columns without their cells.
[[nodiscard]] std::string columns_text(std::span<const TableColumn> columns);
// Reads the same.
[[nodiscard]] Result<std::vector<TableColumn>> read_columns_text(std::string_view text);

// Whether a cell without quotes is read as a number, or as one that is missing.
[[nodiscard]] bool reads_as_number(std::string_view cell);

// The table as a value of the running program, in whose text a call of loadTable has a result of
// these columns; null: the heap is full or the program has to stop, and the failure is set.
[[nodiscard]] RecordObj* new_table(Vm& vm, const TableText& table);

}  // namespace armlet
