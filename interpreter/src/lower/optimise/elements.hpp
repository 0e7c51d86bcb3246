#pragma once
// Looks up an element of a list once for several of its fields.

#include <functional>
#include <vector>

#include "lower/optimise/flow.hpp"

namespace armlet::lang {

// xs[i].x, xs[i].y, xs[i].z: the record xs[i] is looked up once, as long as no instruction between
// the uses can replace it.
//
// fresh  gives an unused register at each call.
[[nodiscard]] Edits share_elements(std::vector<WideInstr>& code, const CodeShape& shape,
                                   const std::function<Reg()>& fresh);

}  // namespace armlet::lang
