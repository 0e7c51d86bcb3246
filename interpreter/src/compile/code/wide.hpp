#pragma once
// Instructions while a function is being compiled: registers are virtual, jumps name labels.

#include <cstdint>
#include <string_view>

#include "compile/code/program.hpp"

namespace armlet::lang {

enum class RegClass : std::uint8_t { kParameter, kReference, kPinned, kNumber };

struct Reg {
  std::uint32_t bits = 0;

  static Reg make(RegClass c, std::uint32_t number) {
    return {static_cast<std::uint32_t>(c) << 28U | number};
  }
  [[nodiscard]] RegClass reg_class() const { return static_cast<RegClass>(bits >> 28U); }
  [[nodiscard]] std::uint32_t number() const { return bits & 0x0FFF'FFFFU; }
  [[nodiscard]] bool is_reference() const { return reg_class() == RegClass::kReference; }
  [[nodiscard]] Reg plus(std::uint32_t n) const { return {bits + n}; }
  bool operator==(const Reg&) const = default;
};

struct WideInstr {
  static constexpr std::uint32_t kNoLabel = 0xFFFF'FFFFU;
  OpCode op;
  std::uint32_t a, b, c;  // bits of registers, or numbers
  std::uint32_t label;
  const hir::Expr* expr;
  Span span;
};

// What the operands of an instruction are: the letters of bytecode.def.
[[nodiscard]] std::string_view operands_of(OpCode op);
// The letter of operand i, 0 to 2.
[[nodiscard]] inline char operand_of(OpCode op, std::size_t i) {
  const std::string_view operands = operands_of(op);
  return i < operands.size() ? operands[i] : '-';
}
[[nodiscard]] inline bool is_register(char operand) {
  return operand == 'd' || operand == 'D' || operand == 'r' || operand == 'R';
}
// After these nothing follows.
[[nodiscard]] bool ends_flow(OpCode op);
// Only operands of the instruction before.
[[nodiscard]] bool is_operand_word(OpCode op);
// The next word is a jump that is taken or skipped.
[[nodiscard]] inline bool is_compare_and_branch(OpCode op) {
  return op >= OpCode::IFLTI && op <= OpCode::FORGEK;
}

// And it changes the register that it compares first.
[[nodiscard]] inline bool counts_and_branches(OpCode op) {
  return op >= OpCode::FORI && op <= OpCode::FORGEK;
}

}  // namespace armlet::lang
