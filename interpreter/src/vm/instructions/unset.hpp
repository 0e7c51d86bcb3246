#pragma once
// Elements that have no value yet, where they are read (R0623).

#include "vm/instructions/slow_ops.hpp"

namespace armlet::lang {

// An element of the list that the running instruction reads.
bool raise_unset_element(VmState& state, std::int64_t index);
SlowOp op_checkset;

// Whether all that a result of the program holds has been set: what functions of the library get
// from it. False: the failure is set.
[[nodiscard]] bool check_result(VmState& state, const UnsetElements& unset, Slot result,
                                const Type& type);

}  // namespace armlet::lang
