#pragma once
// Several fields of one element of a list.

#include <functional>
#include <vector>

#include "lower/optimise/flow.hpp"

namespace armlet::lang {

// xs[i].x, xs[i].y, xs[i].z: the record is looked up once, as long as nothing may come between that
// changes what it is.
//
// fresh  a register of its own for every call.
[[nodiscard]] Edits share_elements(std::vector<WideInstr>& code, const CodeShape& shape,
                                   const std::function<Reg()>& fresh);

}  // namespace armlet::lang
