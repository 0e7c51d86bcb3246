#pragma once
// The form of instructions while a function is compiled: registers are virtual, and jumps name
// labels.

#include <cstdint>

#include "program/program.hpp"
#include "program/properties.hpp"

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
  std::uint32_t a, b, c;  // registers, or numbers
  std::uint32_t label;
  const hir::Expr* expr;
  Span span;
};

}  // namespace armlet::lang
