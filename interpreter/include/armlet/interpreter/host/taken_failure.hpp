#pragma once
// Failures of script functions that the native function which called them can ignore.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "armlet/interpreter/failure.hpp"

namespace armlet {

// The message of a failure, and the data that a failed native function has added to it; null: none,
// as for an error of the program itself.
struct TakenFailure {
  std::string message;
  std::shared_ptr<const FailureDetail> detail;
};

// After a call by a native function (Vm::call) has failed: takes the failure back, so that the
// native function can continue. Empty if the kind of the failure is none of these, or if no `catch`
// could catch it, such as a stop request: the failure then stays set, and the native function has
// to fail.
[[nodiscard]] std::optional<TakenFailure> take_failure(Vm& vm,
                                                       std::span<const std::string_view> kinds);

}  // namespace armlet
