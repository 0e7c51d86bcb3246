#pragma once
// Targets of assignments, and expressions that change a list or map.

#include "hir/hir_expr.hpp"

namespace armlet::lang::hir {

// One step of an assignment target: a target is a variable, followed by fields and elements, as in
// a.b[i].
struct Step {
  bool is_field;
  std::uint32_t field;
  Expr* index;       // elements
  const Type* type;  // of the target after this step
  Span span;         // from the start of the target to the end of this step
  Expr* column;      // elements of matrices
  const Type* map;   // entries of maps: the type of the map, whose key is `index`; else null
};
struct Place {
  Variable* variable;
  Seq<Step> steps;
  const Type* type;
  Span span;
};
enum class Mutation : std::uint8_t { kPush, kPop, kInsert, kRemoveAt, kRemoveKey };
struct MutateExpr : Expr {  // xs.push(x): void; xs.pop(), xs.removeAt(i), m.remove(k): the element
  Mutation mutation;
  Place place;
  Expr* index;  // insert, removeAt; remove: the key
  Expr* value;  // push, insert
};

}  // namespace armlet::lang::hir
