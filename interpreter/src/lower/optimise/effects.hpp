#pragma once
// The registers and the memory that an instruction reads and changes, for optimisation passes.

#include <vector>

#include "program/wide.hpp"

namespace armlet::lang {

struct Effects {
  Effect effect = Effect::kUnknown;
  std::uint32_t words = 1;   // the instruction and its operands in the next word
  bool defines = false;      // register a of the instruction is written
  bool reads_first = false;  // and read before, although it is the destination
  bool empties = false;      // register b is cleared
  // A call overwrites the number registers from `window` on, and reads the first `window_reads` of
  // them.
  static constexpr std::uint32_t kAll = 0x0FFF'FFFFU;
  bool has_window = false;
  Reg window;
  std::uint32_t window_reads = kAll;
  [[nodiscard]] bool reads_in_window(std::uint32_t bits) const {
    return has_window && bits >= window.bits && bits - window.bits < window_reads;
  }
  // A register that the instruction needs under its number, so it cannot be replaced.
  bool has_fixed = false;
  Reg fixed;
};

// The effects of the instruction at `at`, which must not be an operand word.
[[nodiscard]] Effects effects_of(const std::vector<WideInstr>& code, std::uint32_t at);

// Whether the result depends only on the operands and the current contents of memory.
[[nodiscard]] constexpr bool is_load(Effect effect) {
  return effect == Effect::kLoad || effect == Effect::kInside;
}
[[nodiscard]] constexpr bool is_value(Effect effect) {
  return effect == Effect::kPure || is_load(effect);
}

// Calls f(std::uint32_t& bits) for each register that an instruction names and reads, also in its
// operand word; not for register a of a kUpdate.
template <class Code, class F>
void for_each_read(Code& code, std::uint32_t at, const Effects& effects, F f) {
  for (std::uint32_t word = at; word < at + effects.words; ++word) {
    auto& instr = code[word];
    const bool is_target = word == at && effects.defines && !effects.reads_first;
    if (is_register(operand_of(instr.op, 0)) && !is_target) f(instr.a);
    if (is_register(operand_of(instr.op, 1))) f(instr.b);
    if (is_register(operand_of(instr.op, 2))) f(instr.c);
  }
}

// Whether the instruction at `at` may need the contents of the register.
[[nodiscard]] bool reads_register(const std::vector<WideInstr>& code, std::uint32_t at,
                                  const Effects& effects, std::uint32_t bits);

}  // namespace armlet::lang
