#pragma once
// The matrix expressions of a checked program; hir.hpp describes the whole tree.

#include "hir/hir_expr.hpp"

namespace armlet::lang::hir {

struct MatrixExpr : Expr {  // [a, b; c, d]
  std::uint32_t cols;
  Seq<Expr*> items;  // doubles, row by row
};

// One index position between the brackets of a part: a single index, or a range whose ends are
// optional.
struct PartEnds {
  Expr* first;  // null: from the start
  Expr* last;   // null: to the end; unused for an index
  bool is_range;
};
struct PartExpr : Expr {  // matrix[a:b, j]: a list if one of the two is an index, else a matrix
  Expr* object;
  PartEnds rows;
  PartEnds cols;
};

}  // namespace armlet::lang::hir
