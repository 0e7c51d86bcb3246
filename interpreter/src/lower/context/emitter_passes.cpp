// The order of the optimisation passes, and the changes of positions that follow from them.

#include <algorithm>
#include <functional>
#include <utility>

#include "lower/context/emitter.hpp"
#include "lower/optimise/accumulator.hpp"
#include "lower/optimise/combine.hpp"
#include "lower/optimise/elements.hpp"
#include "lower/optimise/fuse.hpp"
#include "lower/optimise/hand_over.hpp"
#include "lower/optimise/loop_invariants.hpp"
#include "lower/optimise/operands.hpp"
#include "lower/optimise/value_numbering.hpp"

namespace armlet::lang {

CodeShape Emitter::shape() const {
  CodeShape shape;
  shape.numbers = most_numbers_;
  shape.references = most_references_;
  for (const LabelInfo& label : labels_) {
    shape.labels.push_back(label.used ? label.position : kUnbound);
  }
  for (const Handler& h : handlers_) shape.handlers.push_back({h.begin, h.end, h.handler});
  for (const WideLoop& l : loops_) shape.counters.push_back(l.counter);
  return shape;
}

void Emitter::improve() {
  const std::function<Reg()> fresh = [this] { return pinned(); };
  edit(hand_over_last_uses(code_, shape()));
  edit(number_values(code_, shape(), fresh));
  edit(hoist_loop_invariants(code_, shape(), fresh));
  edit(fuse(code_, shape()));
  edit(combine(code_, shape()));
  edit(take_operands(code_, shape()));
  edit(share_elements(code_, shape(), fresh));
  edit(use_accumulator(code_, shape()));
}

void Emitter::edit(const Edits& edits) {
  const bool removes = std::ranges::find(edits.removed, true) != edits.removed.end();
  if (!removes && edits.insertions.empty()) return;
  std::vector<WideInstr> code;
  code.reserve(code_.size() + edits.insertions.size());
  // For each old position of an instruction: its new position, and that of a loop that begins
  // there.
  std::vector<std::uint32_t> moved(code_.size() + 1);
  std::vector<std::uint32_t> moved_loops(code_.size() + 1);
  auto next = edits.insertions.begin();
  for (std::uint32_t at = 0; at <= code_.size(); ++at) {
    moved[at] = moved_loops[at] = static_cast<std::uint32_t>(code.size());
    for (; next != edits.insertions.end() && next->at == at; ++next) {
      code.push_back(next->instr);
      if (next->before_loop) moved_loops[at] = static_cast<std::uint32_t>(code.size());
    }
    const bool removed = at == code_.size() || (removes && edits.removed[at]);
    if (!removed) code.push_back(code_[at]);
  }
  code_ = std::move(code);
  relocate(moved, moved_loops);
}

void Emitter::relocate(const std::vector<std::uint32_t>& moved,
                       const std::vector<std::uint32_t>& moved_loops) {
  std::vector<bool> begins_loop(labels_.size(), false);
  for (LabelInfo& label : labels_) label.used = false;  // a pass may have removed jumps
  for (const WideInstr& instr : code_) {
    if (instr.label == kUnbound) continue;
    labels_[instr.label].used = true;
    if (instr.op == OpCode::LOOP) begins_loop[instr.label] = true;
  }
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    std::uint32_t& position = labels_[i].position;
    if (position != kUnbound) position = (begins_loop[i] ? moved_loops : moved)[position];
  }
  for (Handler& h : handlers_) {
    h = {moved[h.begin], moved[h.end], moved[h.handler], h.is_finally};
  }
  for (WideFinally& f : finals_) f = {moved[f.begin], moved[f.end], f.held};
  for (WideLoop& l : loops_) l.range = {moved[l.range.begin], moved[l.range.end]};
  for (ExpandedCall& call : expanded_) {
    call.begin = moved[call.begin];
    call.end = moved[call.end];
  }
}

}  // namespace armlet::lang
