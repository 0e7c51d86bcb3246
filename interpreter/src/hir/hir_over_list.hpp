#pragma once
// Expressions that visit every element of a list.

#include "hir/hir_expr.hpp"

namespace armlet::lang::hir {

// Functions of the library that are loops of the program: what they call is called like any other
// function.
enum class ListVerb : std::uint8_t {
  kMap,       // list, function
  kFilter,    // list, function -> bool
  kFold,      // list, start, function
  kAny,       // list, function -> bool
  kAll,       // list, function -> bool
  kSort,      // list, function -> int, real or text, whether it descends
  kZip,       // list, list -> records of two fields
  kContains,  // list, value
  kIndexOf,   // list, value
};

struct OverListExpr : Expr {
  ListVerb verb;
  Seq<Expr*> operands;  // as above
  CallSite site;
};

}  // namespace armlet::lang::hir
