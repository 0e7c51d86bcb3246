#pragma once
// What can be assigned and changed.

#include "hir/hir_expr.hpp"

namespace armlet::lang::hir {

// A place that can be assigned: a variable, then fields and elements of it.
struct Step {
  bool is_field;
  std::uint32_t field;
  Expr* index;       // elements
  const Type* type;  // of the place after this step
  Span span;         // from the start of the place to the end of this step
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
