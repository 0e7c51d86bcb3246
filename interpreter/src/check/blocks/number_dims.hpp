#pragma once
// Dimensions of numbers whose type has none, as far as the text shows them: a `double[]` may
// contain the speeds of parts that rotate and of parts that slide.

#include <optional>
#include <string>
#include <vector>

#include "armlet/interpreter/binding/dims_fact.hpp"
#include "hir/hir.hpp"

namespace armlet::lang {

struct Checker;

// The dimensions of the numbers in a value, or in the result of a function without parameters, in
// their order, with lists and records one inside the other. An entry is empty if its dimension is
// not known or it is not a number. The search follows facts that rules of the host have stored
// (DimsFact, DimsOfArgumentFact) through constant variables, single elements and slices, lists and
// records, sums and differences, script functions with their arguments, and library functions whose
// result has the dimension of an argument. Products have no known dimension, because a factor may
// convert a unit.
//
// returns  empty if nothing is known, or if no number has a dimension.
[[nodiscard]] std::optional<std::vector<NumberDim>> dims_of_numbers(Checker& checker,
                                                                    const hir::Expr& expr);

// `lab.plot.NAME(value: fn() -> T, ...)`: if the text parameter valueUnits is absent, it becomes
// the units of those numbers in the value whose type has none, such as "rad/s,m/s". Units that are
// known at run time only become "@" with NumberDim::later, and "#2" for a single one. A matrix has
// the units of its columns; a list of lists those of each list; a list one unit for all elements,
// or one for each; a table those of each column, such as "s;rad/s,m/s". Called after all functions
// of the program have been checked.
void finish_units(Checker& checker);

}  // namespace armlet::lang
