#pragma once
// The rules for statements and conditions.

#include "lower/context/lowering.hpp"

namespace armlet::lang {

// ---- lower_branch.cpp
void branch(Lowering& in, const hir::Expr& e, bool when, Label to);

// ---- lower_stmt.cpp
void statement(Lowering& in, const hir::Stmt& s);
void block(Lowering& in, const hir::Block& b);
void scoped(Lowering& in, const hir::Stmt& s);
void init_from(Lowering& in, const hir::Variable& variable, Reg value);
void note_set(Lowering& in, const hir::Variable& variable);

// ---- lower_loop.cpp
void loop(Lowering& in, const hir::LoopStmt& s);
void range(Lowering& in, const hir::RangeStmt& s);
void for_list(Lowering& in, const hir::ForListStmt& s);

// ---- lower_try.cpp
void try_catch(Lowering& in, const hir::TryStmt& s);
void check_throws(Lowering& in, const hir::AssertThrowsStmt& s);
// Leaves the tries above `depth` with their finally blocks, then emits `go`.
void leave(Lowering& in, std::size_t depth, const std::function<void()>& go);

// ---- lower_tasks.cpp
bool starts_watching(const hir::Stmt* s);
void watched_block(Lowering& in, hir::Seq<const hir::Stmt* const> body);
void parallel(Lowering& in, const hir::ParallelStmt& s);
void when(Lowering& in, const hir::WhenStmt& s);
void every(Lowering& in, const hir::EveryStmt& s);

}  // namespace armlet::lang
