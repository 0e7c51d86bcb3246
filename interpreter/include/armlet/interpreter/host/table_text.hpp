#pragma once
// Tables as text: lines of cells below a line with names, as spreadsheets write them.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/native.hpp"
#include "armlet/interpreter/unit.hpp"

namespace armlet {

// The ending of file names of tables.
inline constexpr std::string_view kTableEnding = ".csv";

// A column of numbers, or of texts.
//
// name  a valid name of the language: "q1".
// unit  the unit in brackets, "deg"; empty: plain numbers.
struct TableColumn {
  std::string name;
  std::string unit{};
  Dim dim{};
  bool is_text = false;
  std::vector<double> numbers{};  // SI
  std::vector<std::string> texts{};
};

// All columns have the same length.
struct TableText {
  std::vector<TableColumn> columns;
  std::size_t rows = 0;
};

// Parses comma-separated values (RFC 4180); the separator is a semicolon or a tabulator if the
// first line has one. The first line has the names, each with an optional unit in brackets: `q1
// [deg]`. Characters that are invalid in names become `_`. A column has numbers if it has a unit or
// its first cell is a number without quotes, otherwise texts. A byte order mark, line ends of any
// kind and empty lines at the end are accepted.
//
// returns  the table, or the error with its line and column: a cell that is missing, that is not a
//          number, or that has a decimal comma; a line with another count of cells.
[[nodiscard]] Result<TableText> read_table_text(std::string_view text);

// The names and units of the columns: "t [s], q1 [deg], part: string".
[[nodiscard]] std::string columns_text(std::span<const TableColumn> columns);
// Parses a text made by columns_text.
[[nodiscard]] Result<std::vector<TableColumn>> read_columns_text(std::string_view text);

// Whether a cell without quotes is a number or a missing number.
[[nodiscard]] bool reads_as_number(std::string_view cell);

// Makes the table as a value of the running program, which must contain a call of loadTable with
// these columns. Null, with the failure set, if the heap is full or the program has to stop.
[[nodiscard]] RecordObj* new_table(Vm& vm, const TableText& table);

}  // namespace armlet
