#pragma once
// The dimensions of numbers whose type has none, as far as the text shows them: `double[]` holds
// speeds of parts that turn and slide, one beside the other.

#include <optional>
#include <vector>

#include "armlet/interpreter/unit.hpp"
#include "check/tree/hir.hpp"

namespace armlet::lang {

struct Checker;

// Of a value, or of what a function without parameters gives: one for each thing in it, in the
// order in which they stand there, lists and records within one another; none for a thing that is
// no number or of which nothing is known. They follow facts that rules of the host have left
// (DimsFact) through fixed variables, single elements and slices, lists and records, sums and
// differences, functions of the text that have been checked by then, and functions of the library
// whose result has the dimension of what they are given. Products have none: a factor may be there
// to change the unit.
//
// returns  empty if it is not known how many things there are, or if all of them have none.
[[nodiscard]] std::optional<std::vector<Dim>> dims_of_numbers(Checker& checker,
                                                              const hir::Expr& expr);

}  // namespace armlet::lang
