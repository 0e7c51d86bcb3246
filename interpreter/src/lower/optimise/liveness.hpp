#pragma once
// Liveness analysis: the registers of one class that later blocks of a function may read.

#include <cstdint>
#include <vector>

#include "program/wide.hpp"

namespace armlet::lang {

// Facts about a function, besides its instructions, that the optimisation passes need.
struct CodeShape {
  struct HandlerRange {
    std::uint32_t begin;
    std::uint32_t end;
    std::uint32_t handler;
  };
  std::vector<std::uint32_t> labels;  // positions, by number of the label
  std::vector<HandlerRange> handlers;
  std::vector<Reg> counters;  // of loops: messages of failures read them
  std::uint32_t numbers = 0;  // count of number registers
  std::uint32_t references = 0;
};

struct CodeBlock {
  static constexpr std::uint32_t kNone = 0xFFFF'FFFFU;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::uint32_t dominator = kNone;      // the last block that all paths to here pass through
  std::uint32_t loop_last = kNone;      // if a loop begins with the block: the loop's last block
  std::vector<std::uint32_t> next;      // blocks that may be executed next
  std::vector<std::uint32_t> handlers;  // blocks where failures in this one continue
};

class Liveness {
 public:
  // Analyses the number registers, or the reference registers.
  Liveness(const std::vector<WideInstr>& code, const CodeShape& shape,
           RegClass watched = RegClass::kNumber);

  // False if the function is too large for the analysis.
  [[nodiscard]] bool is_known() const { return known_; }
  [[nodiscard]] const std::vector<CodeBlock>& blocks() const { return blocks_; }
  // Whether the contents of the register at the end of the block, or at a failure in it, may be
  // read.
  [[nodiscard]] bool is_live_after(std::uint32_t block, Reg reg) const;
  [[nodiscard]] bool is_live_in_handler(std::uint32_t block, Reg reg) const;

 private:
  using Bits = std::vector<std::uint64_t>;
  void find_blocks(const CodeShape& shape);
  void link_blocks(const CodeShape& shape);
  void find_dominators(const CodeShape& shape);
  [[nodiscard]] std::uint32_t block_at(std::uint32_t position) const { return block_of_[position]; }
  void read_block(const CodeBlock& block, Bits& reads, Bits& writes) const;
  void solve();

  [[nodiscard]] bool is_watched(Reg reg) const { return reg.reg_class() == watched_; }

  const std::vector<WideInstr>& code_;
  RegClass watched_;
  std::uint32_t registers_;
  std::size_t words_;
  bool known_ = false;
  std::vector<CodeBlock> blocks_;
  std::vector<std::uint32_t> block_of_;
  std::vector<Bits> live_in_;
};

}  // namespace armlet::lang
