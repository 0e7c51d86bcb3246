#pragma once
// The jump targets and loops in the code of a function, and edits that insert and remove
// instructions.

#include <cstdint>
#include <vector>

#include "lower/optimise/liveness.hpp"
#include "program/wide.hpp"

namespace armlet::lang {

struct CodeFlow {
  static constexpr std::uint32_t kNone = 0xFFFF'FFFFU;
  static constexpr std::uint32_t kLongestLoop = 300;  // instructions

  // For each position: whether a jump or a handler leads to it.
  std::vector<bool> targets;
  // For each position where a loop begins: the position of its only LOOP instruction; kNone if
  // there are several, or if the loop is too long.
  std::vector<std::uint32_t> loop_ends;
};
[[nodiscard]] CodeFlow find_flow(const std::vector<WideInstr>& code, const CodeShape& shape);

struct Insertion {
  std::uint32_t at;  // before the instruction there
  bool before_loop;  // of the loop that begins there: executed once, not in each iteration
  WideInstr instr;
};

struct Edits {
  std::vector<bool> removed;          // by position
  std::vector<Insertion> insertions;  // by rising position
};

}  // namespace armlet::lang
