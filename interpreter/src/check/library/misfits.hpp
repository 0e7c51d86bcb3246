#pragma once
// Messages about calls that fit no function: the wrong argument, and the parameters of the most
// similar function.

#include <string_view>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

void report_misfit(Checker& checker, std::string_view name, const Signature& signature, Span callee,
                   Span span, const std::vector<Argument>& arguments, const Fit& fit);

}  // namespace armlet::lang
