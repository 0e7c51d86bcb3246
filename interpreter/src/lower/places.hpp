#pragma once
// The rules for reading, assigning and changing variables, elements and fields.

#include "lower/context/lowering.hpp"

namespace armlet::lang {

// ---- lower_map.cpp
void step_to_entry(Lowering& in, const hir::Step& step, Reg to, Reg key, bool makes);
Reg remove_key(Lowering& in, const hir::MutateExpr& e);

// ---- lower_matrix.cpp
void store_part(Lowering& in, const hir::StorePartStmt& s);

// ---- lower_place.cpp
void check_set(Lowering& in, const hir::Variable& variable);
void assign(Lowering& in, const hir::AssignStmt& s);
void store(Lowering& in, const hir::Variable& variable, const hir::Expr& stored);
void store_register(Lowering& in, const hir::Variable& variable, Reg from);
bool has_key(const hir::Place& place);
Indices index_values(Lowering& in, const hir::Place& place);
Hold hold_for(const hir::Place& place, const hir::Expr& value);
Reg address(Lowering& in, const hir::Place& place, const Indices& indices,
            Missing missing = Missing::kFails);
Reg mutate(Lowering& in, const hir::MutateExpr& e);

}  // namespace armlet::lang
