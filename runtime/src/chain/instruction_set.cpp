#include "armlet/chain/instruction_set.hpp"

#include <fmt/format.h>

#include "armlet/core/error.hpp"

namespace armlet {
namespace {

const char* name_of_set(InstructionSet set) {
  switch (set) {
    case InstructionSet::kBaseline:
      return "baseline";
    case InstructionSet::kAvx2:
      return "AVX2";
    default:
      return "AVX-512";
  }
}

}  // namespace

bool is_supported(InstructionSet set) {
#if defined(__x86_64__)
  switch (set) {
    case InstructionSet::kBaseline:
      return true;
    case InstructionSet::kAvx2:
      return __builtin_cpu_supports("avx2");
    default:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
  }
#else
  return set == InstructionSet::kBaseline;
#endif
}

InstructionSet best_instruction_set() {
  static const InstructionSet best = is_supported(InstructionSet::kAvx512) ? InstructionSet::kAvx512
                                     : is_supported(InstructionSet::kAvx2)
                                         ? InstructionSet::kAvx2
                                         : InstructionSet::kBaseline;
  return best;
}

void check_supported(InstructionSet set) {
  if (is_supported(set)) return;
  throw ArgumentError(
      fmt::format("This machine has no {}; expected a set up to {}, which best_instruction_set() "
                  "returns.",
                  name_of_set(set), name_of_set(best_instruction_set())));
}

}  // namespace armlet
