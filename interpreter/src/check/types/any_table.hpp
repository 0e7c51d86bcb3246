#pragma once
// `table` as a written type stands for tables with any columns.
//
// Parameters and results take their type from what is given, as if none were written. Everywhere
// else (variables, fields, elements of lists) the first table that is put there, from the top of
// the text to its end, says which columns all tables there have: TypePool::join_tables.

#include "check/state/checker.hpp"

namespace armlet::lang {

// `table`, `table[]`, `table[][]` ...
[[nodiscard]] bool is_any_table(const Checker& checker, const ast::TypeExpr* type);
// Null where the type comes from what is given: none is written, or `table`.
const Type* resolve_open(Checker& checker, const ast::TypeExpr* type);
// Whether a value of type `given` may stand where `table`, `table[]` ... is written.
[[nodiscard]] bool fits_any_table(const ast::TypeExpr* type, const Type* given);
// "a table", "a table[]".
[[nodiscard]] std::string any_table_phrase(const ast::TypeExpr* type);

// Looks for the columns of an open table in functions that are still to be checked. False after a
// message, when nothing has been put there.
bool settle(Checker& checker, const hir::Expr& table);
// Tables with different columns, in words: "a table of t and q"; empty for other types.
[[nodiscard]] std::string table_phrase(const Type* type);

}  // namespace armlet::lang
