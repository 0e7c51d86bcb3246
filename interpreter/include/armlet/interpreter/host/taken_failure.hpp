#pragma once
// Failures of a program's function that the native function which called it can do without.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace armlet {

class Vm;

// After a call by a native function (Vm::call) that failed: the message of the failure, which is
// taken back, so that the native function may go on. Nothing if its kind is none of these, or no
// `catch` could take it, such as a stop request: then it stays set, and the native function fails.
[[nodiscard]] std::optional<std::string> take_failure(Vm& vm,
                                                      std::span<const std::string_view> kinds);

}  // namespace armlet
