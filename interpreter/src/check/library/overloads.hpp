#pragma once
// Overload resolution for library functions: every argument fits, fewest conversions, no tie
// (language reference, section 5).

#include <span>
#include <string_view>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// begun  whether the call is incomplete, so that arguments may be missing.
[[nodiscard]] Fit fit(Checker& checker, const Signature& signature,
                      const std::vector<Argument>& arguments, bool ambient, bool begun = false);
bool place_arguments(const Signature& signature, const std::vector<Argument>& arguments, Fit& fit);
// The result for an incomplete call: the function that fits its arguments best, and the result type
// of all functions that fit; null if these types differ.
struct Begun {
  const NativeFunction* function = nullptr;
  Fit fit{};
  const Type* result = nullptr;
};
[[nodiscard]] Begun choose_begun(Checker& checker,
                                 std::span<const NativeFunction* const> candidates,
                                 const std::vector<Argument>& arguments);
// The function that fits best; null after a message.
const NativeFunction* choose(Checker& checker, std::string_view name,
                             std::span<const NativeFunction* const> candidates, Span callee,
                             Span span, const std::vector<Argument>& arguments, Fit& best);

}  // namespace armlet::lang
