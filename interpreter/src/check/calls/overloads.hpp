#pragma once
// Which function of the library a call means: every value fits, fewest conversions, no tie
// (language reference, section 5).

#include <span>
#include <string_view>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// begun  the call may not be written to its end: values may be missing.
[[nodiscard]] Fit fit(Checker& checker, const Signature& signature,
                      const std::vector<Argument>& arguments, bool ambient, bool begun = false);
bool place_arguments(const Signature& signature, const std::vector<Argument>& arguments, Fit& fit);
// Of a call that is not written to its end: the function that fits what is written best, and what
// all that fit give; null: they differ.
struct Begun {
  const NativeFunction* function = nullptr;
  Fit fit{};
  const Type* result = nullptr;
};
[[nodiscard]] Begun choose_begun(Checker& checker,
                                 std::span<const NativeFunction* const> candidates,
                                 const std::vector<Argument>& arguments);
// The best of all; null after a message.
const NativeFunction* choose(Checker& checker, std::string_view name,
                             std::span<const NativeFunction* const> candidates, Span callee,
                             Span span, const std::vector<Argument>& arguments, Fit& best);

}  // namespace armlet::lang
