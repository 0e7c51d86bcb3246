#pragma once
// The rules for expressions, which other rules share.

#include <span>

#include "hir/analysis.hpp"
#include "lower/context/lowering.hpp"

namespace armlet::lang {

// How long a reference has to stay valid if `later` is evaluated before its use.
[[nodiscard]] Hold hold_over(const Lowering& in, const hir::Expr& later);

// ---- lower_number.cpp
Reg value(Lowering& in, const hir::Expr& e);
Reg value_near(Lowering& in, const hir::Expr& e, Dest hint);
void value_into(Lowering& in, const hir::Expr& e, Dest to);
bool in_register(Lowering& in, const hir::Expr& e, Reg& out);
void load_variable(Lowering& in, const hir::Variable& variable, Reg to);
void arithmetic(Lowering& in, Site site, hir::Op op, Reg left, const hir::Expr& right, Reg to);
void load_field(Lowering& in, const hir::FieldExpr& e, Reg to, Hold hold);
void load_element(Lowering& in, const hir::ElementExpr& e, Reg to, Hold hold);

// ---- lower_known.cpp
bool with_small(Lowering& in, Site site, hir::Op op, Reg left, const hir::Expr& right, Reg to);
bool by_power_of_two(Lowering& in, Site site, hir::Op op, Reg left, const hir::Expr& right, Reg to);
bool with_constant(Lowering& in, Site site, hir::Op op, Reg left, const hir::Expr& right, Reg to);

// ---- lower_reference.cpp
Reg borrow(Lowering& in, const hir::Expr& e, Hold hold);
void borrow_into(Lowering& in, const hir::Expr& e, Reg to, Hold hold);
Reg borrow_variable(Lowering& in, const hir::Variable& variable, Hold hold);
Reg null_reference(Lowering& in);
void own_into(Lowering& in, const hir::Expr& e, Reg to);
std::vector<hir::Expr*> joined_parts(const hir::ConcatExpr& e);

// ---- lower_unset.cpp
[[nodiscard]] bool may_be_unset(const Lowering& in, const Type& element);
[[nodiscard]] bool may_hold_unset(const Lowering& in, const Type& type);
[[nodiscard]] bool leads_through_unset(const Lowering& in, const hir::Place& place);
void load_item(Lowering& in, Reg to, Reg list, Reg index, const Type& element,
               const hir::Expr& written);
void check_whole(Lowering& in, const hir::Expr& e, Reg value, bool only_itself = false);
void check_arguments(Lowering& in, const hir::CallNativeExpr& e, Reg base);

// ---- lower_map.cpp
void make_map(Lowering& in, const hir::MapExpr& e, Reg to);
void make_map_list(Lowering& in, const hir::MapQueryExpr& e, Reg to);
void load_entry(Lowering& in, const hir::EntryExpr& e, Reg to, Hold hold);
void own_entry_or(Lowering& in, const hir::EntryExpr& e, Reg to);
void has_key_into(Lowering& in, const hir::MapQueryExpr& e, Reg to);
Reg key(Lowering& in, const hir::Expr& e, Hold hold);

// ---- lower_matrix.cpp
void make_matrix(Lowering& in, const hir::MatrixExpr& e, Reg to);
void make_part(Lowering& in, const hir::PartExpr& e, Reg to);
void load_matrix_element(Lowering& in, const hir::ElementExpr& e, Reg to, Hold hold);

// ---- lower_call.cpp
void window(Lowering& in, hir::Seq<hir::Expr*> arguments, Reg base, Hold hold);
void argument(Lowering& in, const hir::Expr& e, Reg slot, Hold hold);
[[nodiscard]] bool may_be_last_use(const Lowering& in, const hir::Expr& e,
                                   const hir::Variable& variable);
void call_into(Lowering& in, const hir::Expr& e, Dest to);
void call_own(Lowering& in, const hir::Expr& e, Reg to);
void effect(Lowering& in, const hir::Expr& e);
void character_code(Lowering& in, const hir::CharacterExpr& e, Reg to);

// ---- inlining.cpp
void expand(Lowering& in, const hir::CallExpr& e, Dest to);
void expand_body(Lowering& in, Site site, const hir::Function& function,
                 const std::vector<Reg>& arguments, Dest to);
void give_back_here(Lowering& in, const hir::Expr& e);

// ---- lower_over_list.cpp
void over_list(Lowering& in, const hir::OverListExpr& e, Reg to);

}  // namespace armlet::lang
