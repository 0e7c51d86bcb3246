#pragma once
// Failures of a program's function that the native function which called it can do without.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "armlet/interpreter/failure.hpp"

namespace armlet {

// The message of a failure, and what the native function that failed left for whoever takes it
// back; null: nothing. An error that the program itself has made has none.
struct TakenFailure {
  std::string message;
  std::shared_ptr<const FailureDetail> detail;
};

// After a call by a native function (Vm::call) that failed: the failure, which is taken back, so
// that the native function may go on. Nothing if its kind is none of these, or no `catch` could
// take it, such as a stop request: then it stays set, and the native function fails.
[[nodiscard]] std::optional<TakenFailure> take_failure(Vm& vm,
                                                       std::span<const std::string_view> kinds);

}  // namespace armlet
