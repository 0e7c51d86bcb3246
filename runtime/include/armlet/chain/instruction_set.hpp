#pragma once

namespace armlet {

// Size of the processor's vector registers: 2, 4 or 8 numbers. Kernels for batches are compiled for
// each size, and one is chosen at run time.
enum class InstructionSet { kBaseline, kAvx2, kAvx512 };

// Whether this processor has the instruction set; and the largest that it has. Results have the same
// bits on every set.
bool is_supported(InstructionSet set);
InstructionSet best_instruction_set();

// throws  ArgumentError if this processor does not have it.
void check_supported(InstructionSet set);

}  // namespace armlet
