#pragma once
// Joins a load or a computation with the next instruction, if only that one uses the result.

#include "lower/optimise/flow.hpp"

namespace armlet::lang {

//   t = x[i]; if t < v ...            one comparison of an element
//   t = x[i]; u = v + t               one operation with an element; likewise rows[i][j]
//   t = y[j]; x[i] = x[i] + a * t     one update of an element
//   t = global; u = t[i]              one load, or one store
//   t = a * b; u = t + c              one operation on ints
//   t = a % b; if t == 0 ...          one test whether a can be divided
//   i = i + k; if i < n ...           one step of a loop
//   t = order of texts; if t == 0 ... one comparison
// Every word keeps its span of the text, so messages of failures stay the same.
[[nodiscard]] Edits take_operands(std::vector<WideInstr>& code, const CodeShape& shape);

}  // namespace armlet::lang
