#pragma once
// The failure R0623: reading an element that has no value yet.

#include "vm/instructions/slow_ops.hpp"

namespace armlet::lang {

// Raises the failure for an element of the list that the running instruction reads.
bool raise_unset_element(VmState& state, std::int64_t index);
SlowOp op_checkset;

// Checks that all elements in a result of the program have values before a library function gets
// it. If not, returns false with the failure set.
[[nodiscard]] bool check_result(VmState& state, const UnsetElements& unset, Slot result,
                                const Type& type);

}  // namespace armlet::lang
