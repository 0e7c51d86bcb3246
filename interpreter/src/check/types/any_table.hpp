#pragma once
// `table` as a declared type means tables with any columns.
//
// Parameters and results take their type from the argument or the value, as if no type were
// declared. Everywhere else (variables, fields, elements of lists) the first table that is
// assigned, in the order of the text, determines the columns of all tables there:
// TypePool::join_tables.

#include "check/state/checker.hpp"

namespace armlet::lang {

// `table`, `table[]`, `table[][]` ...
[[nodiscard]] bool is_any_table(const Checker& checker, const ast::TypeExpr* type);
// The declared type; null if none is declared, or `table`, so that it follows from the value.
const Type* resolve_open(Checker& checker, const ast::TypeExpr* type);
// Whether a value of type `given` fits a declared `table`, `table[]` ...
[[nodiscard]] bool fits_any_table(const ast::TypeExpr* type, const Type* given);
// The name for messages: "a table", "a table[]".
[[nodiscard]] std::string any_table_phrase(const ast::TypeExpr* type);

// The description of a table's columns: "a table of t and q"; empty for other types.
[[nodiscard]] std::string table_phrase(const Type* type);

}  // namespace armlet::lang
