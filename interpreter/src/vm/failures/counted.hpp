#pragma once
// Variables that a loop counts with, for proposals in messages.

#include "armlet/interpreter/source.hpp"
#include "hir/hir.hpp"

namespace armlet::lang {

// Whether a value is a variable that a loop changes or may change: neither a parameter nor declared
// by `let`.
[[nodiscard]] bool is_counted(const SourceSet& sources, const hir::Expr& value);

}  // namespace armlet::lang
