#pragma once

#include <span>

#include "armlet/chain/instruction_set.hpp"
#include "armlet/model/robot.hpp"

namespace armlet {

// inverse_dynamics() of many motions, one per vector lane: value i of motion k is element [i *
// count + k] of every array. The results have the bits of inverse_dynamics(), whatever the
// instruction set.
//
// q, qd, qdd  n * count joint values, rad or m, and their rates.
// tau         receives n * count joint forces, N m or N.
// set         the instruction set to use.
// throws      ArgumentError if a size is not a multiple of n or differs from the others', a joint
//             value or a result is not finite, or this processor does not have the set.
void inverse_dynamics_batch(const Robot& robot, std::span<const double> q,
                            std::span<const double> qd, std::span<const double> qdd,
                            std::span<double> tau, InstructionSet set = best_instruction_set());

}  // namespace armlet
