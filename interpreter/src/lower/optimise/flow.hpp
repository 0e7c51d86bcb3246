#pragma once
// Where the code of a function is entered, and changes to it that move what comes behind them.

#include <cstdint>
#include <vector>

#include "lower/optimise/liveness.hpp"
#include "program/wide.hpp"

namespace armlet::lang {

struct CodeFlow {
  static constexpr std::uint32_t kNone = 0xFFFF'FFFFU;
  static constexpr std::uint32_t kLongestLoop = 300;  // instructions

  // By position: something else than the instruction before leads here.
  std::vector<bool> targets;
  // By position: the only LOOP that leads back here, of a loop that is not too long; kNone.
  std::vector<std::uint32_t> loop_ends;
};
[[nodiscard]] CodeFlow find_flow(const std::vector<WideInstr>& code, const CodeShape& shape);

struct Insertion {
  std::uint32_t at;  // before the instruction there
  bool before_loop;  // that begins there: done once, not in every pass
  WideInstr instr;
};

struct Edits {
  std::vector<bool> removed;          // by position
  std::vector<Insertion> insertions;  // by rising position
};

}  // namespace armlet::lang
