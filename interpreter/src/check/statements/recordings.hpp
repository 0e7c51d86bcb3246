#pragma once
// record run every (10ms) { q: ... }, and the tables it makes.

#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// rest  the statements behind it in its block; they are checked here, because the recording ends
//       with them.
void check_record(Checker& checker, const ast::RecordStmt& stmt, ast::Seq<ast::Stmt*> rest,
                  std::vector<hir::Stmt*>& out);
// A recording alone where a block could stand.
hir::Stmt* check_lone_record(Checker& checker, const ast::RecordStmt& stmt);

// run.t, run.length
hir::Expr* column_of(Checker& checker, hir::Expr* table, const ast::MemberExpr& member);
// What `for (row in run)` visits.
hir::Expr* rows_of(Checker& checker, hir::Expr* table);

// Whether the function takes the samples of a recording.
[[nodiscard]] bool is_sample(const hir::Function& function);

// E0505, for a condition or for what is recorded.
void report_pause(Checker& checker, const hir::Function& condition, Span span);

}  // namespace armlet::lang
