#pragma once

#include "armlet/chain/instruction_set.hpp"

namespace armlet::bench {

struct NamedSet {
  InstructionSet set;
  const char* name;
};
inline constexpr NamedSet kSets[] = {{InstructionSet::kBaseline, "SSE2"},
                                     {InstructionSet::kAvx2, "AVX2"},
                                     {InstructionSet::kAvx512, "AVX-512"}};

}  // namespace armlet::bench
