#pragma once
// Neighbours that become one instruction.

#include <vector>

#include "lower/optimise/flow.hpp"

namespace armlet::lang {

// Sums and differences of two products; products of two elements that are added to something.
[[nodiscard]] Edits fuse(std::vector<WideInstr>& code, const CodeShape& shape);

}  // namespace armlet::lang
