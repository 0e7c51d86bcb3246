#pragma once
// Which registers of one class are read later, for the blocks of one function.

#include <cstdint>
#include <vector>

#include "program/wide.hpp"

namespace armlet::lang {

// What a pass needs to know about a function besides its instructions.
struct CodeShape {
  struct HandlerRange {
    std::uint32_t begin;
    std::uint32_t end;
    std::uint32_t handler;
  };
  std::vector<std::uint32_t> labels;  // positions, by number
  std::vector<HandlerRange> handlers;
  std::vector<Reg> counters;  // of loops: messages read them whenever something fails
  std::uint32_t numbers = 0;  // number registers
  std::uint32_t references = 0;
};

struct CodeBlock {
  static constexpr std::uint32_t kNone = 0xFFFF'FFFFU;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::uint32_t dominator = kNone;      // the last block that every way to here passes through
  std::uint32_t loop_last = kNone;      // of a block that a loop begins with: the loop's last block
  std::vector<std::uint32_t> next;      // blocks that may follow
  std::vector<std::uint32_t> handlers;  // blocks where failures in this one go on
};

class Liveness {
 public:
  // Of the number registers, or of the reference registers.
  Liveness(const std::vector<WideInstr>& code, const CodeShape& shape,
           RegClass watched = RegClass::kNumber);

  // False: the function is too large to be looked at.
  [[nodiscard]] bool is_known() const { return known_; }
  [[nodiscard]] const std::vector<CodeBlock>& blocks() const { return blocks_; }
  // Whether what the register holds at the end of the block, or when something in it fails, may be
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
