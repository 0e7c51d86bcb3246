#include "lower/optimise/elements.hpp"

#include <algorithm>

#include "lower/optimise/effects.hpp"

namespace armlet::lang {

namespace {

constexpr std::size_t kFewestLoads = 3;
constexpr std::size_t kFewestStores = 2;
constexpr std::uint32_t kFarthestElement = 300;  // instructions between the first and the last use

// Whether the instruction loads a field of an element of a list.
bool loads_field(OpCode op) {
  return has_variant(Variant::kOfRecord, op) && properties_of(op).defines;
}
bool stores_field(OpCode op) {
  return has_variant(Variant::kOfRecord, op) && !properties_of(op).defines;
}

class ElementSharer {
 public:
  ElementSharer(std::vector<WideInstr>& code, const CodeShape& shape,
                const std::function<Reg()>& fresh)
      : code_(code), flow_(find_flow(code, shape)), fresh_(fresh) {}

  Edits run() {
    edits_.removed.assign(code_.size(), false);
    for (std::uint32_t at = 0; at < code_.size(); at += effects_of(code_, at).words) {
      if (loads_field(code_[at].op)) {
        find_uses(at, code_[at].b, code_[at].c, false);
        if (uses_.size() >= kFewestLoads) share_loads();
      } else if (stores_field(code_[at].op)) {
        find_uses(at, code_[at].a, code_[at].b, true);
        if (uses_.size() >= kFewestStores) share_stores();
      }
    }
    return std::move(edits_);
  }

 private:
  // Finds the loads, or the stores, of fields of the same element until the element may be another
  // record.
  void find_uses(std::uint32_t from, std::uint32_t list, std::uint32_t index, bool stores) {
    uses_.clear();
    const auto end = std::min(static_cast<std::uint32_t>(code_.size()), from + kFarthestElement);
    for (std::uint32_t at = from; at < end && (at == from || !flow_.targets[at]);) {
      const WideInstr& instr = code_[at];
      const Effects effects = effects_of(code_, at);
      if (stores && stores_field(instr.op)) {
        if (instr.a != list || instr.b != index) return;
        uses_.push_back(at);
      } else if (!is_value(effects.effect) && effects.effect != Effect::kUpdate &&
                 instr.op != OpCode::MOVE) {
        return;
      } else if (!stores && loads_field(instr.op) && instr.b == list && instr.c == index) {
        uses_.push_back(at);
      }
      if (effects.defines && (instr.a == list || instr.a == index)) return;
      at += effects.words;
    }
  }

  // Inserts the instruction that looks the record up before its first use; returns its register.
  Reg insert_record(OpCode op, std::uint32_t list, std::uint32_t index) {
    const Reg record = fresh_();
    WideInstr look_up = code_[uses_[0]];
    look_up.op = op;
    look_up.a = record.bits;
    look_up.b = list;
    look_up.c = index;
    edits_.insertions.push_back({uses_[0], false, look_up});
    return record;
  }

  void share_loads() {
    const Reg record = insert_record(OpCode::LD, code_[uses_[0]].b, code_[uses_[0]].c);
    for (const std::uint32_t at : uses_) {
      WideInstr& instr = code_[at];
      WideInstr& word = code_[at + 1];
      const bool plain = instr.op == OpCode::LDF;
      instr.op = variant_of(Variant::kOfRecord, instr.op);
      instr.b = record.bits;
      instr.c = plain ? word.b : word.c;
      if (plain) {
        edits_.removed[at + 1] = true;
      } else {
        word = {OpCode::WITH, word.a, 0, 0, word.label, word.expr, word.span};
      }
    }
  }

  void share_stores() {
    const Reg record = insert_record(OpCode::OWNED, code_[uses_[0]].a, code_[uses_[0]].b);
    for (const std::uint32_t at : uses_) {
      WideInstr& instr = code_[at];
      const bool plain = instr.op == OpCode::STLF;
      instr.op = variant_of(Variant::kOfRecord, instr.op);
      instr.a = record.bits;
      instr.b = plain ? code_[at + 1].b : 0;
      if (plain) edits_.removed[at + 1] = true;
    }
  }

  std::vector<WideInstr>& code_;
  CodeFlow flow_;
  const std::function<Reg()>& fresh_;
  std::vector<std::uint32_t> uses_;
  Edits edits_;
};

}  // namespace

Edits share_elements(std::vector<WideInstr>& code, const CodeShape& shape,
                     const std::function<Reg()>& fresh) {
  const bool has_fields = std::ranges::any_of(
      code, [](const WideInstr& instr) { return loads_field(instr.op) || stores_field(instr.op); });
  if (!has_fields) return {};
  return ElementSharer(code, shape, fresh).run();
}

}  // namespace armlet::lang
