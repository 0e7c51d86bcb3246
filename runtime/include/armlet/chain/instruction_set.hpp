#pragma once

namespace armlet {

// What the processor's vector registers hold: 2, 4 or 8 numbers. Kernels for batches are compiled
// for each, and one is chosen at run time.
enum class InstructionSet { kBaseline, kAvx2, kAvx512 };

// Whether this machine has it, and the largest that it has and may use.
bool is_supported(InstructionSet set);
InstructionSet best_instruction_set();

// From now on nothing of the process uses more than this, all robots included. Results are the same
// bits on every set, so this is for those who compare or time them.
void use_at_most(InstructionSet set);

// throws  ArgumentError if this machine lacks it.
void check_supported(InstructionSet set);

}  // namespace armlet
