#pragma once
// Joins several instructions to one, for frequent uses of lists of numbers and of counters.

#include "lower/optimise/flow.hpp"

namespace armlet::lang {

//   t = x[i]; t = t + v; x[i] = t      one update of an element
//   t = x[i]; y[j] = t                 one copy
//   t = x[i]; u = x[j]; x[i] = u; x[j] = t   one exchange
//   t = i + 1; .. x[t] ..              an element beside another
//   t = i * 2; t = t + 1               one instruction
//   i = i + 2; if i <= n ...           one instruction
//   if a < b: c = d, or c = c + 1      no branch
// Every word keeps its span of the text, so messages of failures stay the same.
[[nodiscard]] Edits combine(std::vector<WideInstr>& code, const CodeShape& shape);

}  // namespace armlet::lang
