#pragma once
// record run every (10ms) { q: ... }, and the tables of recordings.

#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// rest  the statements after it in its block; they are checked here, because the recording ends
//       with them.
void check_record(Checker& checker, const ast::RecordStmt& stmt, ast::Seq<ast::Stmt*> rest,
                  std::vector<hir::Stmt*>& out);
// A recording as the only statement of a body without braces.
hir::Stmt* check_lone_record(Checker& checker, const ast::RecordStmt& stmt);

// A column of a table: run.t, run.length.
hir::Expr* column_of(Checker& checker, hir::Expr* table, const ast::MemberExpr& member);
// The list that `for (row in run)` visits.
hir::Expr* rows_of(Checker& checker, hir::Expr* table);

// Whether the function takes the samples of a recording.
[[nodiscard]] bool is_sample(const hir::Function& function);

// Reports E0505 for a pause in a condition or in sampled values.
void report_pause(Checker& checker, const hir::Function& condition, Span span);

}  // namespace armlet::lang
