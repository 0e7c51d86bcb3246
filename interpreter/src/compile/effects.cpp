#include "compile/effects.hpp"

#include <array>
#include <span>

namespace armlet::lang {

namespace {

// Their results depend on their operands alone.
constexpr OpCode kPure[] = {
    OpCode::INT,    OpCode::CONST, OpCode::ADDI,  OpCode::SUBI,  OpCode::MULI,   OpCode::DIVI,
    OpCode::MODI,   OpCode::POWI,  OpCode::NEGI,  OpCode::ADDIK, OpCode::ADDR,   OpCode::SUBR,
    OpCode::MULR,   OpCode::DIVR,  OpCode::MODR,  OpCode::POWR,  OpCode::NEGR,   OpCode::MULADD,
    OpCode::ADDRI,  OpCode::SUBRI, OpCode::MULRI, OpCode::DIVRI, OpCode::SQRT,   OpCode::NOT,
    OpCode::ITOR,   OpCode::RTOI,  OpCode::LTI,   OpCode::LEI,   OpCode::EQI,    OpCode::NEI,
    OpCode::LTR,    OpCode::LER,   OpCode::EQR,   OpCode::NER,   OpCode::CALLD1, OpCode::CALLD2,
    OpCode::CALLD3, OpCode::ADDRK, OpCode::MULRK, OpCode::SCALE, OpCode::SUMP,   OpCode::DIFFP,
};
// And on memory.
constexpr OpCode kLoads[] = {
    OpCode::GLOAD,  OpCode::BLOAD,  OpCode::CAPTURE, OpCode::LEN, OpCode::LENTEXT,
    OpCode::LD,     OpCode::LDI,    OpCode::LDLD,    OpCode::LDF, OpCode::FLD,
    OpCode::ADDLDF, OpCode::SUBLDF, OpCode::MULLDF,  OpCode::LDM,
};
// And on what the register held.
constexpr OpCode kUpdates[] = {
    OpCode::MADD, OpCode::MSUB, OpCode::MADDLD,  OpCode::MADDLDLD, OpCode::LDMUL,
    OpCode::FORI, OpCode::FORX, OpCode::MADDTWO, OpCode::MADDROW,
};
// Instructions that change more than a number register, but nothing that they do not name.
constexpr OpCode kPlain[] = {
    OpCode::MOVE,      OpCode::MOVEREF,   OpCode::TAKE,     OpCode::DROP,    OpCode::TEXT,
    OpCode::TEXTREF,   OpCode::ZERO,      OpCode::GLOADREF, OpCode::GOWN,    OpCode::GSTORE,
    OpCode::GSTOREREF, OpCode::GCHECK,    OpCode::GSET,     OpCode::BOX,     OpCode::BLOADREF,
    OpCode::BSTORE,    OpCode::BSTOREREF, OpCode::CMPTEXT,  OpCode::NEWLIST, OpCode::CHARAT,
    OpCode::ADDRL,     OpCode::ADDRG,     OpCode::ADDRB,    OpCode::ADDRE,   OpCode::ADDRF,
    OpCode::PUT,       OpCode::PUTREF,    OpCode::ST,       OpCode::STF,     OpCode::STLF,
    OpCode::MADDLF,    OpCode::PUSH,      OpCode::PUSHREF,  OpCode::APPEND,  OpCode::TOTEXT,
    OpCode::EXPANDED,  OpCode::CALL,      OpCode::CALLV,    OpCode::CALLN,   OpCode::CONCAT,
    OpCode::MAKEREC,   OpCode::RET,       OpCode::RETREF,   OpCode::RETTAKE, OpCode::RETVOID,
    OpCode::HALT,      OpCode::JUMP,      OpCode::LOOP,     OpCode::JT,      OpCode::JF,
    OpCode::STM,       OpCode::ADDRM,
};

using EffectTable = std::array<Effect, static_cast<std::size_t>(OpCode::kCount)>;

constexpr EffectTable kEffects = [] {
  EffectTable table{};
  table.fill(Effect::kUnknown);
  const auto set = [&](std::span<const OpCode> ops, Effect effect) {
    for (const OpCode op : ops) table[static_cast<std::size_t>(op)] = effect;
  };
  set(kPure, Effect::kPure);
  set(kLoads, Effect::kLoad);
  set(kUpdates, Effect::kUpdate);
  set(kPlain, Effect::kPlain);
  for (auto op = OpCode::IFLTI; op < OpCode::FORI;
       op = static_cast<OpCode>(static_cast<int>(op) + 1)) {
    table[static_cast<std::size_t>(op)] = Effect::kPlain;
  }
  return table;
}();

}  // namespace

Effects effects_of(const std::vector<WideInstr>& code, std::uint32_t at) {
  const WideInstr& instr = code[at];
  Effects effects;
  effects.effect = kEffects[static_cast<std::size_t>(instr.op)];
  const char first = operand_of(instr.op, 0);
  effects.defines = first == 'd' || first == 'D' || effects.effect == Effect::kUpdate;
  effects.empties = instr.op == OpCode::TAKE;
  if (is_compare_and_branch(instr.op)) ++effects.words;
  while (at + effects.words < code.size() && is_operand_word(code[at + effects.words].op)) {
    ++effects.words;
  }
  switch (instr.op) {
    case OpCode::CALL:
    case OpCode::CALLV:
    case OpCode::CALLN:
      effects.has_window = true;
      effects.window = Reg{instr.a};
      break;
    case OpCode::CONCAT:
    case OpCode::MAKEREC:
      effects.has_window = true;
      effects.window = Reg{instr.b};
      break;
    case OpCode::ADDRL:
      effects.has_fixed = true;
      effects.fixed = Reg{instr.b};
      break;
    default:
      break;
  }
  return effects;
}

}  // namespace armlet::lang
