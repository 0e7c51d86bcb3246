#pragma once
// Joins neighbouring arithmetic instructions to one.

#include <vector>

#include "lower/optimise/flow.hpp"

namespace armlet::lang {

// Joins sums and differences of two products, and additions of the product of two elements.
[[nodiscard]] Edits fuse(std::vector<WideInstr>& code, const CodeShape& shape);

}  // namespace armlet::lang
