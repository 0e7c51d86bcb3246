#pragma once
// Checks matrices: literals, indices, assignments to parts, and sizes that follow from the text.

#include <optional>

#include "check/state/checker.hpp"

namespace armlet::lang {

// A literal such as [1, 2; 3, 4]; reports E0335 if the rows have different lengths.
hir::Expr* check_matrix(Checker& checker, const ast::MatrixExpr& matrix);
// The elements and parts A[i, j], A[i, :], A[0:3, 0:3].
hir::Expr* check_matrix_index(Checker& checker, const ast::IndexExpr& index, hir::Expr* matrix);
// A[i, j] as an assignment target; empty after a message.
std::optional<hir::Step> matrix_step(Checker& checker, const ast::IndexExpr& index);

// Whether the last brackets of an assignment target contain a range.
[[nodiscard]] bool is_part(const ast::Expr& target);
// Reports E0328: xs[0:2][1] = v would change a copy.
void refuse_element_of_part(Checker& checker, const ast::IndexExpr& part);

// A part that gets a value: the statement without the value, and the expected type.
struct PartStore {
  hir::StorePartStmt* store;
  Target wanted;
};
std::optional<PartStore> check_part(Checker& checker, const ast::IndexExpr& target, Span statement);
// The statement with its value; null, with E0305, if the text shows that their sizes differ.
hir::Stmt* fill_part(Checker& checker, const PartStore& part, hir::Expr* value, Span target);
// Assigns to a part: xs[1:4] = ..., A[i, :] = ..., A[0:3, 0:3] += ...
hir::Stmt* assign_part(Checker& checker, const ast::IndexExpr& target,
                       const ast::AssignStmt& assign);

// Stores an index in a hidden variable if the result of the assignment contains it twice.
void evaluate_once(Checker& checker, hir::Expr*& index, std::vector<hir::Stmt*>& before);

// The fix for v * A, A / B and similar operations that do not exist.
[[nodiscard]] std::optional<Fix> matrix_operator_fix(const Checker& checker,
                                                     const ast::BinaryExpr& node,
                                                     const hir::Expr& left, const hir::Expr& right);

}  // namespace armlet::lang
