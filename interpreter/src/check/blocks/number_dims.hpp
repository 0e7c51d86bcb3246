#pragma once
// The dimensions of numbers whose type has none, as far as the text shows them: `double[]` holds
// speeds of parts that turn and slide, one beside the other.

#include <optional>
#include <string>
#include <vector>

#include "armlet/interpreter/binding/dims_fact.hpp"
#include "hir/hir.hpp"

namespace armlet::lang {

struct Checker;

// Of a value, or of what a function without parameters gives: one for each thing in it, in the
// order in which they stand there, lists and records within one another; none for a thing that is
// no number or of which nothing is known. They follow facts that rules of the host have left
// (DimsFact, DimsOfArgumentFact) through fixed variables, single elements and slices, lists and
// records, sums and differences, functions of the text with what they are given, and functions of
// the library whose result has the dimension of what they are given. Products have none: a factor
// may be there to change the unit.
//
// returns  empty if nothing is known, or if all of them have none.
[[nodiscard]] std::optional<std::vector<NumberDim>> dims_of_numbers(Checker& checker,
                                                                    const hir::Expr& expr);

// `lab.plot.NAME(value: fn() -> T, ...)`: a text parameter valueUnits that is left out gets the
// units of the numbers in the value that have none by their type, as "rad/s,m/s"; those that only
// the run knows as "@" with NumberDim::later, and "#2" for one of them. Of a matrix these are the
// units of its columns, of a list of lists those of each list; of a list the unit of all elements,
// or those of each; of a table those of each column, as "s;rad/s,m/s". When all functions of the
// text have been checked.
void finish_units(Checker& checker);

}  // namespace armlet::lang
