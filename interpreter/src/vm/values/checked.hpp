#pragma once
// Checks of what a host's functions leave and pass, too costly for every build: a build with
// ARMLET_CHECKED makes them.

#include <span>
#include <string>

#include "vm/state/state.hpp"

namespace armlet::lang {

// Why a slot cannot hold a value of this type, as "a text where a list is expected"; empty if it
// can. Reads the object if the slot could hold one at all.
[[nodiscard]] std::string slot_fault(Slot slot, const Type& type);

// Throws ArgumentError unless the arguments are values of the function's parameters, which are as
// many.
void require_values(const hir::Function& function, std::span<const Slot> arguments);

// Calls the native function of the call that the frame is at, and fails if it is done without a
// result of its type: none was left, or a reference to an argument without a count of its own.
[[nodiscard]] Signal call_checked(VmState& state, const Frame& frame, const Thunk& thunk,
                                  Slot* args);

}  // namespace armlet::lang
