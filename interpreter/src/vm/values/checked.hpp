#pragma once
// Checks of the arguments and results of host functions. They are too slow for every build: only
// builds with ARMLET_CHECKED make them.

#include <span>
#include <string>

#include "vm/state/state.hpp"

namespace armlet::lang {

// The reason why a slot cannot be a value of this type, such as "a text where a list is expected";
// empty if it can. Reads the object if the slot may be the address of one.
[[nodiscard]] std::string slot_fault(Slot slot, const Type& type);

// Throws ArgumentError unless the arguments have the count and the types of the function's
// parameters.
void require_values(const hir::Function& function, std::span<const Slot> arguments);

// Calls the native function at the frame's position. It fails if the function has set no result of
// its type, or has returned a reference to an argument without increasing its count.
[[nodiscard]] Signal call_checked(VmState& state, const Frame& frame, const Thunk& thunk,
                                  Slot* args);

}  // namespace armlet::lang
