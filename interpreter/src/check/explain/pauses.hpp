#pragma once
// Conditions and samples that would take time.

#include <string_view>

#include "check/state/checker.hpp"

namespace armlet::lang {

// How the names of functions begin that take the samples of a recording.
inline constexpr std::string_view kSampleName = "record on line ";
// Whether the function takes the samples of a recording.
[[nodiscard]] bool is_sample(const hir::Function& function);
// Reports E0505 for a pause in a condition or in sampled values.
void report_pause(Checker& checker, const hir::Function& condition, Span span);

}  // namespace armlet::lang
