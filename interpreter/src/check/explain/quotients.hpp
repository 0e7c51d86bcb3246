#pragma once
// Advice about quotients of whole numbers.

#include <string>

#include "check/state/checker.hpp"

namespace armlet::lang {

// W0701: where a fraction was perhaps meant. `value` is what the quotient is.
void advise_whole_quotient(Checker& checker, Span whole, Span left, Span right,
                           const std::string& value);

}  // namespace armlet::lang
