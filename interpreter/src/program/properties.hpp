#pragma once
// Properties of instructions for the passes of the compiler: the columns of bytecode.def.

#include <array>
#include <string_view>

#include "program/opcode.hpp"

namespace armlet::lang {

// The instruction that is executed after an instruction.
enum class ControlFlow : std::uint8_t {
  kNext,     // the next instruction
  kJump,     // the next instruction, or the target of its jump
  kTest,     // compares: the next word is a jump that is taken or skipped
  kEnd,      // none here: return, failure or jump
  kOperand,  // never executed: operands of the instruction before
};

// The memory that an instruction reads and changes, besides the registers that it names.
enum class Effect : std::uint8_t {
  kPure,     // the result depends only on the operands; so does whether it fails
  kLoad,     // the result depends also on lists, records and global variables
  kInside,   // the result depends also on the list or record in register b
  kUpdate,   // the result depends also on the old value of register a
  kLocal,    // other effects, without changes of memory
  kStoreA,   // stores into the list or record in register a, which may be a variable
  kStoreB,   // stores into the list or record in register b
  kMemory,   // changes other memory, but only registers that it names
  kUnknown,  // unknown
};

// The change of the accumulator: the double that was computed last, which the virtual machine keeps
// in a register of the processor.
enum class Last : std::uint8_t {
  kForgets,  // its value is lost
  kKeeps,    // its value stays, unless its register is written
  kMakes,    // Ra is the new value
};

// The operand that is the first of a row of registers.
enum class WindowKind : std::uint8_t {
  kNone,
  kArguments,  // from a on: c - 1 registers, or all if c is 0
  kCounted,    // from b on: c registers
  kOpen,       // from b on: all
  kPair,       // c and the register behind it
};

struct Properties {
  std::string_view name;
  std::array<char, 3> operands;
  ControlFlow flow;
  Effect effect;
  Last last;
  WindowKind window = WindowKind::kNone;
  bool defines = false;      // register a
  bool reads_first = false;  // and reads it before, although it is a destination
  bool empties = false;      // register b
  bool has_fixed = false;    // register b cannot be replaced by another one
  bool commutes = false;     // b and c may be exchanged
};

// Special cases of an instruction that have an instruction of their own, its variant.
enum class Variant : std::uint8_t {
  // Rows VARIANT of bytecode.def.
  kLastA,  // the accumulator is Ra, Rb, Rc, or Ra of the next word
  kLastB,
  kLastC,
  kLastW,
  kBeforeLoop,         // of a comparison: the next word is a LOOP
  kEach,               // as the only instruction of a loop
  kWithoutReferences,  // in frames without reference registers
  // Rows of variants.def.
  kTurned,          // of a comparison: the operands are exchanged
  kSmall,           // with a small constant on the right
  kWithInt,         // with an int on the right
  kWithConstant,    // with a constant on the right
  kElementLeft,     // with an element of a list on the left
  kElementRight,    // on the right
  kElementOfRow,    // with an element of a row on either side
  kElementFactor,   // with an element as one of the factors
  kFieldOfElement,  // with a field of an element of a list on the right
  kOfRecord,        // of a field of an element: the field of a record
  kElementChanged,  // of an element: the result is stored into it again
  kAndAdd,          // and adds a register
  kAndAddSmall,     // and adds a small constant
  kBehindStep,      // of a comparison: Ra += Rc before it
  kBehindCount,     // Ra += c before it
  kBehindCountOne,  // of these: c is 1
  kOtherwiseMove,   // of a comparison: a move that is executed if it is false
  kOtherwiseCount,  // of a comparison: Ra += c that is executed if it is false
  kIfZero,          // of an instruction that computes an int: compares the int with 0
  kIfNotZero,       // the same for "is not 0"
  kProductInstead,  // with the product of two registers in place of Ra
  kElementInstead,  // with an element in place of the factor in the next word
  kCount,
};

namespace detail {

constexpr std::string_view kLetters = "dDuUrRsTmawWpijcCtfnk-";
constexpr std::string_view kRegisterLetters = "dDuUrRsTmawWp";

constexpr Properties with_operands(Properties p) {
  const auto [a, b, c] = p.operands;
  p.defines = a == 'd' || a == 'D' || a == 'u' || a == 'U';
  p.reads_first = a == 'U';
  p.empties = b == 'T';
  p.has_fixed = b == 'm';
  p.commutes = b == 's' && c == 's';
  if (a == 'a') p.window = WindowKind::kArguments;
  if (b == 'w') p.window = WindowKind::kCounted;
  if (b == 'W') p.window = WindowKind::kOpen;
  if (c == 'p') p.window = WindowKind::kPair;
  return p;
}

constexpr std::size_t number(OpCode op) { return static_cast<std::size_t>(op); }

// A variant takes its columns from an instruction above it in the table.
constexpr std::array<Properties, kOpCodes> kProperties = [] {
  std::array<Properties, kOpCodes> table{};
  const auto set = [&](OpCode op, std::string_view name, const char(&operands)[4], ControlFlow flow,
                       Effect effect, Last last) {
    table[number(op)] =
        with_operands({name, {operands[0], operands[1], operands[2]}, flow, effect, last});
  };
  const auto set_variant = [&](OpCode op, std::string_view name, OpCode base) {
    table[number(op)] = table[number(base)];
    table[number(op)].name = name;
  };
#define OP(name, operands, flow, effect, last, text) \
  set(OpCode::name, #name, operands, ControlFlow::flow, Effect::effect, Last::last);
#define VARIANT(name, base, variant) set_variant(OpCode::name, #name, OpCode::base);
#include "program/bytecode.def"
#undef VARIANT
#undef OP
  return table;
}();

constexpr auto kVariants = static_cast<std::size_t>(Variant::kCount);

constexpr std::array<std::array<OpCode, kOpCodes>, kVariants> kVariantOf = [] {
  std::array<std::array<OpCode, kOpCodes>, kVariants> table{};
  for (auto& of_one : table) of_one.fill(OpCode::HALT);
  const auto set = [&](OpCode base, Variant variant, OpCode op) {
    table[static_cast<std::size_t>(variant)][number(base)] = op;
  };
#define OP(...)
#define VARIANT(name, base, variant) set(OpCode::base, Variant::variant, OpCode::name);
#include "program/bytecode.def"
#include "program/variants.def"
#undef VARIANT
#undef OP
  return table;
}();

constexpr std::array<bool, 128> kIsRegister = [] {
  std::array<bool, 128> table{};
  for (const char letter : kRegisterLetters) table[static_cast<std::size_t>(letter)] = true;
  return table;
}();

}  // namespace detail

[[nodiscard]] constexpr const Properties& properties_of(OpCode op) {
  return detail::kProperties[detail::number(op)];
}

// The kind of operand i, 0 to 2, as a letter of bytecode.def.
[[nodiscard]] constexpr char operand_of(OpCode op, std::size_t i) {
  return properties_of(op).operands[i];
}
[[nodiscard]] constexpr bool is_register(char operand) {
  return detail::kIsRegister[static_cast<std::size_t>(operand)];
}
// Whether no instruction follows: the next one is reached by jumps only.
[[nodiscard]] constexpr bool ends_flow(OpCode op) {
  return properties_of(op).flow == ControlFlow::kEnd;
}
// Whether the word only has operands of the instruction before.
[[nodiscard]] constexpr bool is_operand_word(OpCode op) {
  return properties_of(op).flow == ControlFlow::kOperand;
}
// Whether the next word is a jump, which is executed or skipped.
[[nodiscard]] constexpr bool is_compare_and_branch(OpCode op) {
  return properties_of(op).flow == ControlFlow::kTest;
}

// The value for "no variant"; HALT is not a variant.
inline constexpr OpCode kNoVariant = OpCode::HALT;

// The variant of an instruction for a special case, or kNoVariant.
[[nodiscard]] constexpr OpCode variant_of(Variant variant, OpCode op) {
  return detail::kVariantOf[static_cast<std::size_t>(variant)][detail::number(op)];
}
[[nodiscard]] constexpr bool has_variant(Variant variant, OpCode op) {
  return variant_of(variant, op) != kNoVariant;
}

}  // namespace armlet::lang
