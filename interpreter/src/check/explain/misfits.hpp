#pragma once
// Messages about calls that fit no function: which value, and what the closest function takes.

#include <string_view>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

void report_misfit(Checker& checker, std::string_view name, const Signature& signature, Span callee,
                   Span span, const std::vector<Argument>& arguments, const Fit& fit);

}  // namespace armlet::lang
