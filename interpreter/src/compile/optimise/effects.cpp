#include "compile/optimise/effects.hpp"

#include <array>
#include <span>

namespace armlet::lang {

namespace {

// Their results depend on their operands alone.
constexpr OpCode kPure[] = {
    OpCode::INT,    OpCode::CONST, OpCode::ADDI,  OpCode::SUBI,   OpCode::MULI,   OpCode::DIVI,
    OpCode::MODI,   OpCode::POWI,  OpCode::NEGI,  OpCode::ADDIK,  OpCode::ADDR,   OpCode::SUBR,
    OpCode::MULR,   OpCode::DIVR,  OpCode::MODR,  OpCode::POWR,   OpCode::NEGR,   OpCode::MULADD,
    OpCode::ADDRI,  OpCode::SUBRI, OpCode::MULRI, OpCode::DIVRI,  OpCode::SQRT,   OpCode::NOT,
    OpCode::ITOR,   OpCode::RTOI,  OpCode::LTI,   OpCode::LEI,    OpCode::EQI,    OpCode::NEI,
    OpCode::LTR,    OpCode::LER,   OpCode::EQR,   OpCode::NER,    OpCode::CALLD1, OpCode::CALLD2,
    OpCode::CALLD3, OpCode::ADDRK, OpCode::MULRK, OpCode::SCALE,  OpCode::SUMP,   OpCode::DIFFP,
    OpCode::MULIK,  OpCode::DIVP,  OpCode::MODP,  OpCode::SCALEI, OpCode::MADDIK, OpCode::MULADDI,
    OpCode::ADDIIK,
};
// And on memory.
constexpr OpCode kLoads[] = {
    OpCode::GLOAD,  OpCode::BLOAD,  OpCode::CAPTURE, OpCode::LEN,   OpCode::LENTEXT, OpCode::LD,
    OpCode::LDI,    OpCode::LDLD,   OpCode::LDF,     OpCode::FLD,   OpCode::ADDLDF,  OpCode::SUBLDF,
    OpCode::MULLDF, OpCode::LDM,    OpCode::LDO,     OpCode::ADDIX, OpCode::SUBIX,   OpCode::XSUBI,
    OpCode::MULIX,  OpCode::ADDIXK, OpCode::ADDIXX,  OpCode::ADDRX, OpCode::SUBRX,   OpCode::XSUBR,
    OpCode::MULRX,  OpCode::LDG,    OpCode::CODEAT,  OpCode::ROW,
};
// And on what the register held.
constexpr OpCode kUpdates[] = {
    OpCode::MADD,  OpCode::MSUB,    OpCode::MADDLD,  OpCode::MADDLDLD,
    OpCode::LDMUL, OpCode::MADDTWO, OpCode::MADDROW,
};
// Instructions that change more than a number register, but nothing that they do not name.
constexpr OpCode kPlain[] = {
    OpCode::MOVE,      OpCode::MOVEREF,  OpCode::TAKE,       OpCode::GIVE,      OpCode::ADOPT,
    OpCode::DROP,      OpCode::TEXT,     OpCode::TEXTREF,    OpCode::ZERO,      OpCode::GLOADREF,
    OpCode::GOWN,      OpCode::GSTORE,   OpCode::GSTOREREF,  OpCode::GCHECK,    OpCode::GSET,
    OpCode::BOX,       OpCode::BLOADREF, OpCode::BSTORE,     OpCode::BSTOREREF, OpCode::CMPTEXT,
    OpCode::NEWLIST,   OpCode::CHARAT,   OpCode::ADDRL,      OpCode::ADDRG,     OpCode::ADDRB,
    OpCode::ADDRE,     OpCode::ADDRF,    OpCode::PUT,        OpCode::PUTREF,    OpCode::ST,
    OpCode::STF,       OpCode::STLF,     OpCode::MADDLF,     OpCode::PUSH,      OpCode::PUSHREF,
    OpCode::APPEND,    OpCode::TOTEXT,   OpCode::EXPANDED,   OpCode::CALL,      OpCode::CALLV,
    OpCode::CALLN,     OpCode::CONCAT,   OpCode::MAKEREC,    OpCode::RET,       OpCode::RETREF,
    OpCode::RETTAKE,   OpCode::RETVOID,  OpCode::HALT,       OpCode::JUMP,      OpCode::LOOP,
    OpCode::JT,        OpCode::JF,       OpCode::STM,        OpCode::ADDRM,     OpCode::STO,
    OpCode::STLD,      OpCode::COPYEL,   OpCode::SWAPEL,     OpCode::COUNTEL,   OpCode::ADDEL,
    OpCode::SUBEL,     OpCode::ADDELR,   OpCode::SUBELR,     OpCode::MULELR,    OpCode::MADDEL,
    OpCode::MSUBEL,    OpCode::OWNED,    OpCode::OWNEDF,     OpCode::POP,       OpCode::INSERT,
    OpCode::INSERTREF, OpCode::EQDEEP,   OpCode::LISTTOREAL, OpCode::SLICE,     OpCode::SLICETEXT,
    OpCode::MAKELIST,  OpCode::NEWARRAY, OpCode::STRIDE,     OpCode::SETF,      OpCode::MADDF,
    OpCode::NEWMAP,    OpCode::MAPADD,   OpCode::MAPLD,      OpCode::MAPGET,    OpCode::MAPHAS,
    OpCode::MAPLEN,    OpCode::MAPKEYS,  OpCode::MAPVALUES,  OpCode::ENTRYADDR, OpCode::ENTRYMAKE,
    OpCode::MAPPOP,    OpCode::MADDELX,  OpCode::MSUBELX,    OpCode::STG,       OpCode::SWITCH,
    OpCode::OWNROW,    OpCode::LDSET,    OpCode::PLACESET,   OpCode::CHECKSET,
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
  const auto set_all = [&](OpCode first, OpCode last, Effect effect) {
    for (auto op = static_cast<std::size_t>(first); op <= static_cast<std::size_t>(last); ++op) {
      table[op] = effect;
    }
  };
  set_all(OpCode::IFLTI, OpCode::IFNETK, Effect::kPlain);
  set_all(OpCode::FORI, OpCode::FORGEK, Effect::kUpdate);
  set_all(OpCode::MOVELTI, OpCode::COUNTLER, Effect::kUpdate);
  return table;
}();

void set_window(Effects& effects, std::uint32_t first, std::uint32_t reads) {
  effects.has_window = true;
  effects.window = Reg{first};
  effects.window_reads = reads;
}

}  // namespace

Effects effects_of(const std::vector<WideInstr>& code, std::uint32_t at) {
  const WideInstr& instr = code[at];
  Effects effects;
  effects.effect = kEffects[static_cast<std::size_t>(instr.op)];
  const char first = operand_of(instr.op, 0);
  effects.defines = first == 'd' || first == 'D' || effects.effect == Effect::kUpdate;
  effects.reads_first = instr.op == OpCode::RETTAKE || instr.op == OpCode::APPEND;
  effects.empties = instr.op == OpCode::TAKE || instr.op == OpCode::GIVE;
  if (is_compare_and_branch(instr.op)) ++effects.words;
  if (instr.op == OpCode::SWITCH) effects.words += instr.c + 1;
  while (at + effects.words < code.size() && is_operand_word(code[at + effects.words].op)) {
    ++effects.words;
  }
  switch (instr.op) {
    case OpCode::CALL:
    case OpCode::CALLV:
    case OpCode::CALLN:
      set_window(effects, instr.a, instr.c == 0 ? Effects::kAll : instr.c - 1);
      break;
    case OpCode::CONCAT:
    case OpCode::NEWARRAY:
      set_window(effects, instr.b, instr.c);
      break;
    case OpCode::MAKEREC:
      set_window(effects, instr.b, Effects::kAll);
      break;
    case OpCode::MAKELIST:
      if (Reg{instr.b}.is_reference()) {
        effects.effect = Effect::kUnknown;
      } else {
        set_window(effects, instr.b, instr.c);
      }
      break;
    case OpCode::SLICE:
    case OpCode::SLICETEXT:
      set_window(effects, instr.c, 2);
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

bool reads_register(const std::vector<WideInstr>& code, std::uint32_t at, const Effects& effects,
                    std::uint32_t bits) {
  bool reads = effects.effect == Effect::kUnknown || effects.reads_in_window(bits) ||
               (effects.has_fixed && effects.fixed.bits == bits) ||
               (effects.effect == Effect::kUpdate && code[at].a == bits);
  for_each_read(code, at, effects, [&](std::uint32_t read) { reads = reads || read == bits; });
  return reads;
}

}  // namespace armlet::lang
