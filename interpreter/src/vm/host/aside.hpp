#pragma once

#include <span>

#include "vm/state/state.hpp"

namespace armlet::lang {

// VmState::evaluate for a function with parameters. The arguments are borrowed.
[[nodiscard]] bool evaluate_with(VmState& state, Task& owner, Obj* function,
                                 std::span<const Slot> arguments, Slot& result);

}  // namespace armlet::lang
