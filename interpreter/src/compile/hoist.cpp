#include "compile/hoist.hpp"

#include <algorithm>

#include "compile/effects.hpp"

namespace armlet::lang {

namespace {

bool can_fail(OpCode op) {
  switch (op) {
    case OpCode::MOVE:
    case OpCode::INT:
    case OpCode::CONST:
    case OpCode::ADDR:
    case OpCode::SUBR:
    case OpCode::MULR:
    case OpCode::DIVR:
    case OpCode::NEGR:
    case OpCode::MADD:
    case OpCode::MSUB:
    case OpCode::MULADD:
    case OpCode::ITOR:
      return false;
    default:
      return true;
  }
}

// Lists and records are as they were.
bool leaves_memory(const WideInstr& instr, const Effects& effects) {
  switch (effects.effect) {
    case Effect::kPure:
    case Effect::kLoad:
    case Effect::kUpdate:
      return true;
    case Effect::kPlain:
      return is_compare_and_branch(instr.op) || instr.op == OpCode::MOVE ||
             instr.op == OpCode::JUMP || instr.op == OpCode::JT || instr.op == OpCode::JF ||
             instr.op == OpCode::EXPANDED;
    case Effect::kUnknown:
      return false;
  }
  return false;
}

class RowHoister {
 public:
  RowHoister(std::vector<WideInstr>& code, const CodeShape& shape,
             const std::function<Reg()>& fresh)
      : code_(code), flow_(find_flow(code, shape)), fresh_(fresh) {}

  Edits run() {
    edits_.removed.assign(code_.size(), false);
    for (std::uint32_t at = 0; at < code_.size(); ++at) {
      if (flow_.loop_ends[at] == CodeFlow::kNone || !is_quiet(at, flow_.loop_ends[at])) continue;
      if (const std::uint32_t row = first_row(at); row != CodeFlow::kNone) hoist(at, row);
    }
    return std::move(edits_);
  }

 private:
  // Only computes, and contains no other loop. Notes the registers that it writes.
  bool is_quiet(std::uint32_t begin, std::uint32_t end) {
    written_.clear();
    for (std::uint32_t at = begin; at < end;) {
      if (at != begin && flow_.loop_ends[at] != CodeFlow::kNone) return false;
      const Effects effects = effects_of(code_, at);
      if (!leaves_memory(code_[at], effects)) return false;
      if (effects.defines) written_.push_back(code_[at].a);
      at += effects.words;
    }
    return true;
  }

  bool stays(std::uint32_t reg) const { return std::ranges::find(written_, reg) == written_.end(); }

  std::uint32_t first_row(std::uint32_t begin) const {
    for (std::uint32_t at = begin; at == begin || !flow_.targets[at];) {
      const WideInstr& instr = code_[at];
      if (instr.op == OpCode::LDLD || instr.op == OpCode::MADDLDLD) {
        return stays(instr.b) && stays(instr.c) ? at : CodeFlow::kNone;
      }
      if (can_fail(instr.op)) return CodeFlow::kNone;
      at += effects_of(code_, at).words;
    }
    return CodeFlow::kNone;
  }

  void hoist(std::uint32_t loop, std::uint32_t at) {
    WideInstr& whole = code_[at];
    WideInstr& inner = code_[at + 1];  // what belongs to rows[i][j]
    const Reg row = fresh_();
    WideInstr load = whole;
    load.op = OpCode::LD;
    load.a = row.bits;
    edits_.insertions.push_back({loop, true, load});
    const bool multiplies = whole.op == OpCode::MADDLDLD;
    whole = {multiplies ? OpCode::MADDLD : OpCode::LD,
             whole.a,
             row.bits,
             multiplies ? inner.b : inner.a,
             whole.label,
             inner.expr,
             inner.span};
    if (multiplies) {
      inner.op = OpCode::WITH;
      inner.b = 0;
    } else {
      edits_.removed[at + 1] = true;
    }
  }

  std::vector<WideInstr>& code_;
  CodeFlow flow_;
  const std::function<Reg()>& fresh_;
  Edits edits_;
  std::vector<std::uint32_t> written_;  // by the loop that is looked at
};

}  // namespace

Edits hoist_rows(std::vector<WideInstr>& code, const CodeShape& shape,
                 const std::function<Reg()>& fresh) {
  const bool has_rows = std::ranges::any_of(code, [](const WideInstr& instr) {
    return instr.op == OpCode::LDLD || instr.op == OpCode::MADDLDLD;
  });
  // A failure in front of a loop could miss a handler inside it.
  if (!has_rows || !shape.handlers.empty()) return {};
  return RowHoister(code, shape, fresh).run();
}

}  // namespace armlet::lang
