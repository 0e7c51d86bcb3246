#pragma once

namespace armlet {

// What the processor's vector registers hold: 2, 4 or 8 numbers. Kernels for batches are compiled
// for each, and one is chosen at run time.
enum class InstructionSet { kBaseline, kAvx2, kAvx512 };

// Whether this machine has it, and the largest that it has.
bool is_supported(InstructionSet set);
InstructionSet best_instruction_set();

// throws  ArgumentError if this machine lacks it.
void check_supported(InstructionSet set);

}  // namespace armlet
