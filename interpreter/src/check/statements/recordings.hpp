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

}  // namespace armlet::lang
