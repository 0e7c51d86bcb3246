#pragma once
// Which variables a loop counts, for what messages propose.

#include "armlet/interpreter/source.hpp"
#include "hir/hir.hpp"

namespace armlet::lang {

// Whether a value is a variable that a loop counts, or may count: no parameter, nor what `let`
// declares.
[[nodiscard]] bool is_counted(const SourceSet& sources, const hir::Expr& value);

}  // namespace armlet::lang
