#include "lower/optimise/loop_invariants.hpp"

#include <algorithm>

#include "lower/optimise/deaths.hpp"
#include "lower/optimise/effects.hpp"

namespace armlet::lang {

namespace {

constexpr std::size_t kMostRows = 8;  // in one loop; VmState::kMissingRows has the same limit

// Whether the instruction stores a number into a list in a register, or makes a row the only owner
// of its contents.
bool stores_numbers(OpCode op) {
  return op == OpCode::ST || op == OpCode::STLD || op == OpCode::OWNED;
}

// Whether the instruction uses the register only as a list.
bool takes_list(const WideInstr& instr, std::uint32_t reg) {
  if (instr.op == OpCode::ST) return instr.a == reg && instr.b != reg && instr.c != reg;
  const bool looks_up = instr.op == OpCode::LD || instr.op == OpCode::OWNED;
  return looks_up && instr.b == reg && instr.c != reg;
}

// Whether the instruction leaves every row in its list of lists. Stores may copy a shared row
// first, which keeps its contents.
bool leaves_rows(const WideInstr& instr, const Effects& effects) {
  if (is_value(effects.effect) || effects.effect == Effect::kUpdate) return true;
  const ControlFlow flow = properties_of(instr.op).flow;
  return flow == ControlFlow::kTest || flow == ControlFlow::kJump || instr.op == OpCode::MOVE ||
         instr.op == OpCode::JUMP || instr.op == OpCode::EXPANDED || stores_numbers(instr.op);
}

class RowHoister {
 public:
  RowHoister(std::vector<WideInstr>& code, const CodeShape& shape,
             const std::function<Reg()>& fresh)
      : code_(code), flow_(find_flow(code, shape)), deaths_(code, shape), fresh_(fresh) {}

  Edits run() {
    edits_.removed.assign(code_.size(), false);
    for (std::uint32_t at = 0; at < code_.size(); ++at) {
      if (flow_.loop_ends[at] == CodeFlow::kNone || !look_at_loop(at, flow_.loop_ends[at]))
        continue;
      loop_ = at;
      rows_.clear();
      segment_ = 0;
      for (std::uint32_t i = at; i < end_;) {
        const OpCode op = code_[i].op;
        use_row(i);
        i += effects_of(code_, i).words;
        if (properties_of(op).flow != ControlFlow::kNext || flow_.targets[i]) ++segment_;
      }
    }
    return std::move(edits_);
  }

 private:
  struct Row {
    std::uint32_t list;
    std::uint32_t index;
    std::uint32_t segment;  // number of the straight part of the loop with the first use
    Reg row;
  };

  // Whether the loop contains only computations and stores of numbers, and no inner loop. Collects
  // the registers that it writes and the lists whose rows it stores into.
  bool look_at_loop(std::uint32_t begin, std::uint32_t end) {
    written_.clear();
    changed_.clear();
    end_ = end;
    for (std::uint32_t at = begin; at < end;) {
      if (at != begin && flow_.loop_ends[at] != CodeFlow::kNone) return false;
      const Effects effects = effects_of(code_, at);
      const WideInstr& instr = code_[at];
      if (!leaves_rows(instr, effects)) return false;
      if (effects.defines) written_.push_back(instr.a);
      if (instr.op == OpCode::STLD) changed_.push_back(instr.a);
      if (instr.op == OpCode::OWNED) changed_.push_back(instr.b);
      at += effects.words;
    }
    return true;
  }

  bool stays(std::uint32_t reg) const { return std::ranges::find(written_, reg) == written_.end(); }
  bool is_changed(std::uint32_t list) const {
    return std::ranges::find(changed_, list) != changed_.end();
  }
  // Whether another register may refer to the same list; only variables have lists of their own.
  bool may_be_changed_elsewhere(std::uint32_t list) const {
    const auto is_variable = [](std::uint32_t bits) { return Reg{bits}.is_reference(); };
    return !is_variable(list) && std::ranges::any_of(changed_, [&](std::uint32_t other) {
      return other != list && !is_variable(other);
    });
  }

  void use_row(std::uint32_t at) {
    const OpCode op = code_[at].op;
    if (op == OpCode::LDLD || op == OpCode::MADDLDLD) load(at);
    if (op == OpCode::STLD) store(at);
    if (op == OpCode::OWNED) own(at);
  }

  // The register with row `index` of `list`, which is looked up before the loop; `at` is the
  // position of the use. Returns false if the row changes in the loop or if there are too many
  // rows. A missing row is reported at its first use, so another use can share the register only if
  // the first one is executed before it in each iteration.
  bool row_of(std::uint32_t at, std::uint32_t list, std::uint32_t index, Reg& out) {
    for (const Row& row : rows_) {
      if (row.list != list || row.index != index) continue;
      if (row.segment != 0 && row.segment != segment_) continue;
      out = row.row;
      return true;
    }
    if (rows_.size() == kMostRows || !stays(list) || !stays(index)) return false;
    if (may_be_changed_elsewhere(list)) return false;
    out = fresh_();
    const WideInstr& instr = code_[at];
    const OpCode op = is_changed(list) ? OpCode::OWNROW : OpCode::ROW;
    edits_.insertions.push_back(
        {loop_, true, {op, out.bits, list, index, WideInstr::kNoLabel, instr.expr, instr.span}});
    edits_.insertions.push_back({loop_,
                                 true,
                                 {OpCode::OFFSET, 0, 0, static_cast<std::uint32_t>(rows_.size()),
                                  WideInstr::kNoLabel, instr.expr, instr.span}});
    rows_.push_back({list, index, segment_, out});
    return true;
  }

  void load(std::uint32_t at) {
    WideInstr& whole = code_[at];
    WideInstr& inner = code_[at + 1];  // the access to an element of the row
    Reg row;
    if (!row_of(at, whole.b, whole.c, row)) return;
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
      remove(at + 1);
    }
  }

  void store(std::uint32_t at) {
    WideInstr& whole = code_[at];
    const WideInstr& inner = code_[at + 1];
    Reg row;
    if (!row_of(at, whole.a, whole.b, row)) return;
    whole = {OpCode::ST, row.bits, inner.a, whole.c, whole.label, inner.expr, inner.span};
    remove(at + 1);
  }

  // Lets the instructions after `at` that read the copied row use the register of the hoisted row.
  void own(std::uint32_t at) {
    const WideInstr whole = code_[at];
    Reg row;
    std::vector<std::uint32_t*> reads;
    std::uint32_t i = at + effects_of(code_, at).words;
    bool ends = false;
    for (; !ends && i < end_ && !flow_.targets[i]; i += effects_of(code_, i).words) {
      const Effects effects = effects_of(code_, i);
      const std::size_t before = reads.size();
      for_each_read(code_, i, effects, [&](std::uint32_t& bits) {
        if (bits == whole.a) reads.push_back(&bits);
      });
      if (reads.size() > before && !takes_list(code_[i], whole.a)) return;
      ends = effects.defines && code_[i].a == whole.a;
      if (is_compare_and_branch(code_[i].op) || ends_flow(code_[i].op)) break;
      if (!ends && deaths_.dies(whole.a, i)) ends = true;
    }
    if (!ends || !row_of(at, whole.b, whole.c, row)) return;
    for (std::uint32_t* read : reads) *read = row.bits;
    remove(at);
  }

  void remove(std::uint32_t at) {
    code_[at] = {OpCode::OFFSET, 0, 0, 0, WideInstr::kNoLabel, code_[at].expr, code_[at].span};
    edits_.removed[at] = true;
  }

  std::vector<WideInstr>& code_;
  CodeFlow flow_;
  Deaths deaths_;
  const std::function<Reg()>& fresh_;
  Edits edits_;
  std::uint32_t loop_ = 0;  // the loop that is analysed, and its end
  std::uint32_t end_ = 0;
  std::uint32_t segment_ = 0;  // count of its straight parts so far
  std::vector<std::uint32_t> written_;
  std::vector<std::uint32_t> changed_;
  std::vector<Row> rows_;
};

}  // namespace

Edits hoist_loop_invariants(std::vector<WideInstr>& code, const CodeShape& shape,
                            const std::function<Reg()>& fresh) {
  const bool has_rows = std::ranges::any_of(code, [](const WideInstr& instr) {
    return instr.op == OpCode::LDLD || instr.op == OpCode::MADDLDLD || instr.op == OpCode::STLD ||
           instr.op == OpCode::OWNED;
  });
  // A failure before a loop would not reach a handler inside of it.
  if (!has_rows || !shape.handlers.empty()) return {};
  return RowHoister(code, shape, fresh).run();
}

}  // namespace armlet::lang
