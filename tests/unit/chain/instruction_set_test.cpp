#include "armlet/chain/instruction_set.hpp"

#include <doctest/doctest.h>

#include "armlet/core/error.hpp"

using namespace armlet;

TEST_CASE(
    "the best instruction set is the largest that is supported, and larger ones are refused") {
  CHECK(is_supported(InstructionSet::kBaseline));
  const InstructionSet best = best_instruction_set();
  for (const InstructionSet set :
       {InstructionSet::kBaseline, InstructionSet::kAvx2, InstructionSet::kAvx512}) {
    CHECK(is_supported(set) == (set <= best));
    if (is_supported(set)) {
      CHECK_NOTHROW(check_supported(set));
    } else {
      CHECK_THROWS_WITH_AS(check_supported(set), doctest::Contains("This machine has no AVX"),
                           ArgumentError);
    }
  }
}
