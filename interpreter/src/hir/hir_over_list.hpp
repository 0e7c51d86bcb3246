#pragma once
// Expressions that visit every element of a list: map, filter, fold and others.

#include "hir/hir_expr.hpp"

namespace armlet::lang::hir {

// Functions of the library that are compiled to loops. The functions given to them are called like
// other functions of the program.
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
