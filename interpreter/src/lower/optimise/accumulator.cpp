#include "lower/optimise/accumulator.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "lower/optimise/effects.hpp"

namespace armlet::lang {

namespace {

constexpr std::uint32_t kNone = 0xFFFF'FFFFU;  // the bits of no register

constexpr Variant kVariants[] = {Variant::kLastA, Variant::kLastB, Variant::kLastC,
                                 Variant::kLastW};

Last change_by(OpCode op) { return properties_of(op).last; }

// Visits the instructions in their order. `held` is always the bits of the register whose value the
// accumulator has: the double that was computed last.
class LastDouble {
 public:
  LastDouble(std::vector<WideInstr>& code, const CodeShape& shape)
      : code_(code), flow_(find_flow(code, shape)) {}

  Edits run() {
    std::uint32_t held = kNone;
    for (std::uint32_t at = 0; at < code_.size();) {
      if (flow_.targets[at]) held = enter(at);
      choose_variant(at, held);
      held = after(at, held);
      at += effects_of(code_, at).words;
    }
    return std::move(edits_);
  }

 private:
  // A loop may need a double at the start of each iteration that it computes at the end of the one
  // before. The accumulator then gets that double before the first iteration as well. Returns the
  // register, or kNone.
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

  // Whether the first double computed from here on has `held` as an operand.
  bool begins_with(std::uint32_t at, std::uint32_t held) const {
    for (std::uint32_t i = at; i < code_.size() && (i == at || !flow_.targets[i]);
         i += effects_of(code_, i).words) {
      if (change_by(code_[i].op) == Last::kMakes) return find_variant(i, held).has_value();
      if (after(i, held) != held) return false;
    }
    return false;
  }

  std::uint32_t after(std::uint32_t at, std::uint32_t held) const {
    const WideInstr& instr = code_[at];
    switch (change_by(instr.op)) {
      case Last::kForgets:
        return kNone;
      case Last::kKeeps:
        return properties_of(instr.op).defines && instr.a == held ? kNone : held;
      case Last::kMakes:
        return instr.a;
    }
    return kNone;
  }

  // The form of the instruction that takes its operand `held` from the accumulator.
  std::optional<Variant> find_variant(std::uint32_t at, std::uint32_t held) const {
    const WideInstr& instr = code_[at];
    if (change_by(instr.op) != Last::kMakes) return std::nullopt;
    const auto variant = std::ranges::find_if(
        kVariants, [&](Variant f) { return has_variant(f, instr.op) && is_operand(at, f, held); });
    return variant == std::end(kVariants) ? std::nullopt : std::optional(*variant);
  }

  bool is_operand(std::uint32_t at, Variant variant, std::uint32_t held) const {
    const WideInstr& instr = code_[at];
    if (variant == Variant::kLastA) return instr.a == held;
    if (variant == Variant::kLastB) {
      return instr.b == held || (properties_of(instr.op).commutes && instr.c == held);
    }
    return variant == Variant::kLastC ? instr.c == held : code_[at + 1].a == held;
  }

  void choose_variant(std::uint32_t at, std::uint32_t held) {
    if (held == kNone) return;
    WideInstr& instr = code_[at];
    if (instr.op == OpCode::RET && instr.a == held) instr.op = OpCode::RET_A;
    const std::optional<Variant> variant = find_variant(at, held);
    if (!variant) return;
    if (variant == Variant::kLastB && instr.b != held) std::swap(instr.b, instr.c);
    instr.op = variant_of(*variant, instr.op);
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
