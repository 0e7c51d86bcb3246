#pragma once
// Matrices while a program is checked: literals, indexing, assignment to parts, and the sizes that
// the text shows.

#include <optional>

#include "check/state/checker.hpp"

namespace armlet::lang {

// [1, 2; 3, 4]: E0335 when the rows differ in length.
hir::Expr* check_matrix(Checker& checker, const ast::MatrixExpr& matrix);
// A[i, j], A[i, :], A[0:3, 0:3].
hir::Expr* check_matrix_index(Checker& checker, const ast::IndexExpr& index, hir::Expr* matrix);
// A[i, j] as the place that an assignment changes; empty after a message.
std::optional<hir::Step> matrix_step(Checker& checker, const ast::IndexExpr& index);

// Whether a range stands between the last brackets of what is assigned to.
[[nodiscard]] bool is_part(const ast::Expr& target);
// E0328: xs[0:2][1] = v would store in a copy.
void refuse_element_of_part(Checker& checker, const ast::IndexExpr& part);

// A part that gets a value: the statement, which has none yet, and what it takes.
struct PartStore {
  hir::StorePartStmt* store;
  Target wanted;
};
std::optional<PartStore> check_part(Checker& checker, const ast::IndexExpr& target, Span statement);
// The statement with its value; null with E0305 if the text shows that they differ in size.
hir::Stmt* fill_part(Checker& checker, const PartStore& part, hir::Expr* value, Span target);
// xs[1:4] = ..., A[i, :] = ..., A[0:3, 0:3] += ...
hir::Stmt* assign_part(Checker& checker, const ast::IndexExpr& target,
                       const ast::AssignStmt& assign);

// Where an index stands twice in what an assignment becomes, it is kept in a hidden variable.
void evaluate_once(Checker& checker, hir::Expr*& index, std::vector<hir::Stmt*>& before);

// A list where a matrix is needed: how a matrix with these rows is written.
[[nodiscard]] std::optional<Fix> matrix_from_list_fix(const Checker& checker,
                                                      const hir::Expr& list);
// v * A, A / B and their like: what to write instead.
[[nodiscard]] std::optional<Fix> matrix_operator_fix(const Checker& checker,
                                                     const ast::BinaryExpr& node,
                                                     const hir::Expr& left, const hir::Expr& right);

}  // namespace armlet::lang
