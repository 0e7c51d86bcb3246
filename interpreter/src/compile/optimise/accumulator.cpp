#include "compile/optimise/accumulator.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "compile/optimise/effects.hpp"

namespace armlet::lang {

namespace {

constexpr std::uint32_t kNone = 0xFFFF'FFFFU;  // the bits of no register

enum class Operand : std::uint8_t { kA, kB, kC, kNextA };

struct Form {
  OpCode usual;
  Operand operand;  // taken from the processor
  OpCode chosen;
};

constexpr Form kForms[] = {
    {OpCode::ADDR, Operand::kB, OpCode::ADDR_B},
    {OpCode::SUBR, Operand::kB, OpCode::SUBR_B},
    {OpCode::SUBR, Operand::kC, OpCode::SUBR_C},
    {OpCode::MULR, Operand::kB, OpCode::MULR_B},
    {OpCode::DIVR, Operand::kB, OpCode::DIVR_B},
    {OpCode::DIVR, Operand::kC, OpCode::DIVR_C},
    {OpCode::MADD, Operand::kA, OpCode::MADD_A},
    {OpCode::MADD, Operand::kB, OpCode::MADD_B},
    {OpCode::MSUB, Operand::kA, OpCode::MSUB_A},
    {OpCode::MSUB, Operand::kB, OpCode::MSUB_B},
    {OpCode::MULADD, Operand::kB, OpCode::MULADD_B},
    {OpCode::MULADD, Operand::kNextA, OpCode::MULADD_W},
    {OpCode::ADDRI, Operand::kB, OpCode::ADDRI_B},
    {OpCode::SUBRI, Operand::kB, OpCode::SUBRI_B},
    {OpCode::ADDRX, Operand::kNextA, OpCode::ADDRX_W},
    {OpCode::SUBRX, Operand::kNextA, OpCode::SUBRX_W},
    {OpCode::XSUBR, Operand::kNextA, OpCode::XSUBR_W},
    {OpCode::MULRX, Operand::kNextA, OpCode::MULRX_W},
    {OpCode::MULRI, Operand::kB, OpCode::MULRI_B},
    {OpCode::DIVRI, Operand::kB, OpCode::DIVRI_B},
    {OpCode::ADDRK, Operand::kB, OpCode::ADDRK_B},
    {OpCode::MULRK, Operand::kB, OpCode::MULRK_B},
    {OpCode::SCALE, Operand::kB, OpCode::SCALE_B},
    {OpCode::SQRT, Operand::kB, OpCode::SQRT_B},
    {OpCode::LDMUL, Operand::kA, OpCode::LDMUL_A},
    {OpCode::MADDLD, Operand::kA, OpCode::MADDLD_A},
    {OpCode::MADDLD, Operand::kNextA, OpCode::MADDLD_W},
    {OpCode::MADDLDLD, Operand::kA, OpCode::MADDLDLD_A},
    {OpCode::MADDLDLD, Operand::kNextA, OpCode::MADDLDLD_W},
    {OpCode::MADDTWO, Operand::kA, OpCode::MADDTWO_A},
    {OpCode::MADDROW, Operand::kA, OpCode::MADDROW_A},
    {OpCode::ADDF, Operand::kNextA, OpCode::ADDF_W},
    {OpCode::SUBF, Operand::kNextA, OpCode::SUBF_W},
    {OpCode::MULF, Operand::kNextA, OpCode::MULF_W},
    {OpCode::ADDLDF, Operand::kNextA, OpCode::ADDLDF_W},
    {OpCode::SUBLDF, Operand::kNextA, OpCode::SUBLDF_W},
    {OpCode::MULLDF, Operand::kNextA, OpCode::MULLDF_W},
};

// Their second and third operands may change places.
bool is_symmetric(OpCode op) {
  switch (op) {
    case OpCode::ADDR:
    case OpCode::MULR:
    case OpCode::MADD:
    case OpCode::MSUB:
    case OpCode::MULADD:
      return true;
    default:
      return false;
  }
}

enum class Change : std::uint8_t {
  kForgets,  // the double computed last is lost
  kKeeps,    // it stays, unless its register is written
  kMakes,    // Ra is the double computed last
};

using ChangeTable = std::array<Change, static_cast<std::size_t>(OpCode::kCount)>;

constexpr ChangeTable kChanges = [] {
  ChangeTable table{};
  table.fill(Change::kForgets);
  const auto set = [&](OpCode op, Change change) { table[static_cast<std::size_t>(op)] = change; };
  for (const Form& form : kForms) {
    set(form.usual, Change::kMakes);
    set(form.chosen, Change::kMakes);
  }
  for (const OpCode op : {OpCode::SUMP, OpCode::DIFFP, OpCode::NEGR, OpCode::MODR, OpCode::ITOR,
                          OpCode::CALLD1, OpCode::CALLD2, OpCode::CALLD3}) {
    set(op, Change::kMakes);
  }
  for (const OpCode op :
       {OpCode::MOVE,   OpCode::INT,    OpCode::CONST,   OpCode::ZERO,     OpCode::GLOAD,
        OpCode::GSTORE, OpCode::ADDI,   OpCode::SUBI,    OpCode::MULI,     OpCode::DIVI,
        OpCode::MODI,   OpCode::NEGI,   OpCode::ADDIK,   OpCode::NOT,      OpCode::LTI,
        OpCode::LEI,    OpCode::EQI,    OpCode::NEI,     OpCode::LTR,      OpCode::LER,
        OpCode::EQR,    OpCode::NER,    OpCode::LEN,     OpCode::LD,       OpCode::LDLD,
        OpCode::LDI,    OpCode::LDF,    OpCode::FLD,     OpCode::BSTORE,   OpCode::PUT,
        OpCode::ST,     OpCode::STF,    OpCode::STLF,    OpCode::MADDLF,   OpCode::STM,
        OpCode::OWNED,  OpCode::SETF,   OpCode::MADDF,   OpCode::ADDRL,    OpCode::ADDRG,
        OpCode::ADDRB,  OpCode::ADDRE,  OpCode::ADDRF,   OpCode::ADDRM,    OpCode::LDM,
        OpCode::BLOAD,  OpCode::JT,     OpCode::JF,      OpCode::EXPANDED, OpCode::MULIK,
        OpCode::SCALEI, OpCode::DIVP,   OpCode::MODP,    OpCode::LDO,      OpCode::STO,
        OpCode::STLD,   OpCode::COPYEL, OpCode::SWAPEL,  OpCode::COUNTEL,  OpCode::ADDEL,
        OpCode::SUBEL,  OpCode::ADDELR, OpCode::SUBELR,  OpCode::MULELR,   OpCode::MADDEL,
        OpCode::MSUBEL, OpCode::OWNEDF, OpCode::MADDELX, OpCode::MSUBELX,  OpCode::STG,
        OpCode::LDG,    OpCode::ADDIX,  OpCode::SUBIX,   OpCode::XSUBI,    OpCode::MULIX,
        OpCode::ADDIXK, OpCode::ADDIXX, OpCode::MADDIK,  OpCode::MULADDI,  OpCode::ADDIIK,
        OpCode::ROW,    OpCode::OWNROW}) {
    set(op, Change::kKeeps);
  }
  const auto set_all = [&](OpCode first, OpCode last) {
    for (auto op = static_cast<int>(first); op <= static_cast<int>(last); ++op) {
      set(static_cast<OpCode>(op), Change::kKeeps);
    }
  };
  set_all(OpCode::IFLTI, OpCode::FORGEK);
  for (const OpCode op : {OpCode::IFEQT, OpCode::IFNET, OpCode::IFEQTK, OpCode::IFNETK}) {
    set(op, Change::kForgets);
  }
  set_all(OpCode::MOVELTI, OpCode::COUNTLER);
  return table;
}();

Change change_by(OpCode op) { return kChanges[static_cast<std::size_t>(op)]; }

// Walks the code once in its order. `held` is always the register whose value is the double
// computed last, by its bits.
class LastDouble {
 public:
  LastDouble(std::vector<WideInstr>& code, const CodeShape& shape)
      : code_(code), flow_(find_flow(code, shape)) {}

  Edits run() {
    std::uint32_t held = kNone;
    for (std::uint32_t at = 0; at < code_.size();) {
      if (flow_.targets[at]) held = enter(at);
      choose_form(at, held);
      held = after(at, held);
      at += effects_of(code_, at).words;
    }
    return std::move(edits_);
  }

 private:
  // A loop whose passes all end with the double that the next one needs first gets it before the
  // first pass too.
  std::uint32_t enter(std::uint32_t at) {
    const std::uint32_t end = flow_.loop_ends[at];
    if (end == CodeFlow::kNone) return kNone;
    std::uint32_t carried = kNone;
    for (std::uint32_t i = at; i < end; i += effects_of(code_, i).words) {
      if (i != at && flow_.targets[i]) carried = kNone;
      carried = after(i, carried);
    }
    if (carried == kNone || !begins_with(at, carried)) return kNone;
    const WideInstr& first = code_[at];
    const WideInstr load{OpCode::LAST, carried, 0, 0, WideInstr::kNoLabel, first.expr, first.span};
    edits_.insertions.push_back({at, true, load});
    return carried;
  }

  // The first double computed from here on is computed from `held`.
  bool begins_with(std::uint32_t at, std::uint32_t held) const {
    for (std::uint32_t i = at; i < code_.size() && (i == at || !flow_.targets[i]);
         i += effects_of(code_, i).words) {
      if (change_by(code_[i].op) == Change::kMakes) return form_of(i, held) != nullptr;
      if (after(i, held) != held) return false;
    }
    return false;
  }

  std::uint32_t after(std::uint32_t at, std::uint32_t held) const {
    const WideInstr& instr = code_[at];
    switch (change_by(instr.op)) {
      case Change::kForgets:
        return kNone;
      case Change::kKeeps: {
        const bool counts = counts_and_branches(instr.op);
        const bool writes = operand_of(instr.op, 0) == 'd' || counts;
        return writes && instr.a == held ? kNone : held;
      }
      case Change::kMakes:
        return instr.a;
    }
    return kNone;
  }

  // The form of the instruction that takes `held` from the processor; null: there is none.
  const Form* form_of(std::uint32_t at, std::uint32_t held) const {
    const WideInstr& instr = code_[at];
    if (change_by(instr.op) != Change::kMakes) return nullptr;
    const bool symmetric = is_symmetric(instr.op);
    for (const Form& form : kForms) {
      if (form.usual != instr.op) continue;
      const bool fits = form.operand == Operand::kA ? instr.a == held
                        : form.operand == Operand::kB
                            ? instr.b == held || (symmetric && instr.c == held)
                        : form.operand == Operand::kC ? instr.c == held
                                                      : code_[at + 1].a == held;
      if (fits) return &form;
    }
    return nullptr;
  }

  void choose_form(std::uint32_t at, std::uint32_t held) {
    if (held == kNone) return;
    WideInstr& instr = code_[at];
    if (instr.op == OpCode::RET && instr.a == held) instr.op = OpCode::RET_A;
    const Form* form = form_of(at, held);
    if (form == nullptr) return;
    if (form->operand == Operand::kB && instr.b != held) std::swap(instr.b, instr.c);
    instr.op = form->chosen;
  }

  std::vector<WideInstr>& code_;
  CodeFlow flow_;
  Edits edits_;
};

}  // namespace

Edits use_accumulator(std::vector<WideInstr>& code, const CodeShape& shape) {
  return LastDouble(code, shape).run();
}

}  // namespace armlet::lang
