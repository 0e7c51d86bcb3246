#pragma once
// Which function of the library a call means: every value fits, fewest conversions, no tie
// (language reference, section 5).

#include <span>
#include <string_view>
#include <vector>

#include "check/checker.hpp"

namespace armlet::lang {

[[nodiscard]] Fit fit(Checker& checker, const Signature& signature,
                      const std::vector<Argument>& arguments, bool ambient);
bool place_arguments(const Signature& signature, const std::vector<Argument>& arguments, Fit& fit);
// The best of all; null after a message.
const NativeFunction* choose(Checker& checker, std::string_view name,
                             std::span<const NativeFunction* const> candidates, Span callee,
                             Span span, const std::vector<Argument>& arguments, Fit& best);

}  // namespace armlet::lang
