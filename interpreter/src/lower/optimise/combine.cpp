#include "lower/optimise/combine.hpp"

#include <algorithm>

#include "lower/optimise/deaths.hpp"
#include "lower/optimise/effects.hpp"

namespace armlet::lang {

namespace {

constexpr std::size_t kMostUses = 3;         // of the index of an element beside another
constexpr std::uint32_t kFarthestPair = 40;  // instructions in which uses of an index are searched

// The instructions for a move or an increment that runs if a comparison fails, in place of a branch
// around it.
struct Choice {
  OpCode move = kNoVariant;
  OpCode count = kNoVariant;
  bool turned = false;
};
Choice otherwise(OpCode op) {
  const bool turned =
      !has_variant(Variant::kOtherwiseMove, op) && has_variant(Variant::kTurned, op);
  const OpCode test = turned ? variant_of(Variant::kTurned, op) : op;
  return {variant_of(Variant::kOtherwiseMove, test), variant_of(Variant::kOtherwiseCount, test),
          turned};
}

// The instruction for Ra += c with the comparison after it. `second`: Ra is the second operand of
// the comparison.
OpCode counting(OpCode op, bool second, std::uint32_t by) {
  const OpCode variant =
      variant_of(Variant::kBehindCount, second ? variant_of(Variant::kTurned, op) : op);
  const OpCode by_one = variant_of(Variant::kBehindCountOne, variant);
  return by == 1 && by_one != kNoVariant ? by_one : variant;
}

class Combiner {
 public:
  Combiner(std::vector<WideInstr>& code, const CodeShape& shape)
      : code_(code), shape_(shape), deaths_(code, shape), ways_(code.size() + 1, 0) {}

  Edits run() {
    edits_.removed.assign(code_.size(), false);
    count_ways();
    for (std::uint32_t at = 0; at < code_.size(); at += effects_of(code_, at).words) look_at(at);
    split_late_words();
    return std::move(edits_);
  }

 private:
  void count_ways() {
    for (const WideInstr& instr : code_) {
      if (instr.label != WideInstr::kNoLabel) ++ways_[shape_.labels[instr.label]];
    }
    for (const auto& handler : shape_.handlers) ++ways_[handler.handler];
  }

  // Whether the next `count` words exist and no jump leads into them.
  bool is_straight(std::uint32_t at, std::uint32_t count) const {
    if (at + count > code_.size()) return false;
    for (std::uint32_t i = at + 1; i < at + count; ++i) {
      if (ways_[i] != 0) return false;
    }
    return true;
  }

  void look_at(std::uint32_t at) {
    const OpCode op = code_[at].op;
    if (op == OpCode::LD) {
      (void)(exchange(at) || change_element(at) || copy_element(at));
    } else if (op == OpCode::ADDIK) {
      (void)(count_and_branch(at) || look_beside(at));
    } else if (op == OpCode::MULIK) {
      scale(at);
    } else if (is_compare_and_branch(op)) {
      choose_without_branch(at);
    }
  }

  // Removes a word from the code. Until the end of the pass it is an operand that names no
  // register.
  void remove(std::uint32_t at) {
    code_[at].op = OpCode::OFFSET;
    edits_.removed[at] = true;
  }
  void make_operand(std::uint32_t at, OpCode op, std::uint32_t a, std::uint32_t b,
                    std::uint32_t c) {
    WideInstr& word = code_[at];
    word = {op, a, b, c, WideInstr::kNoLabel, word.expr, word.span};
  }

  bool exchange(std::uint32_t at) {
    if (!is_straight(at, 4)) return false;
    WideInstr& one = code_[at];
    const WideInstr& other = code_[at + 1];
    const WideInstr& first = code_[at + 2];
    const WideInstr& second = code_[at + 3];
    if (other.op != OpCode::LD || first.op != OpCode::ST || second.op != OpCode::ST) return false;
    const bool same_list = other.b == one.b && first.a == one.b && second.a == one.b;
    const bool crossed =
        first.b == one.c && second.b == other.c && first.c == other.a && second.c == one.a;
    if (!same_list || !crossed || one.a == other.a || one.a == other.c) return false;
    for (const std::uint32_t index : {one.c, other.c, one.b}) {
      if (index == one.a || index == other.a) return false;
    }
    if (!deaths_.dies(one.a, at + 3) || !deaths_.dies(other.a, at + 3)) return false;
    one = {OpCode::SWAPEL, one.b, one.c, other.c, one.label, one.expr, one.span};
    make_operand(at + 1, OpCode::PAIR, one.a, one.b, 0);
    make_operand(at + 2, OpCode::PAIR, one.a, one.b, 0);
    remove(at + 3);
    return true;
  }

  bool change_element(std::uint32_t at) {
    if (!is_straight(at, 3)) return false;
    WideInstr& load = code_[at];
    const WideInstr change = code_[at + 1];
    const WideInstr& store = code_[at + 2];
    const OpCode op = variant_of(Variant::kElementChanged, change.op);
    const std::uint32_t t = load.a;
    if (op == kNoVariant || store.op != OpCode::ST || change.a != t || store.c != t) return false;
    if (store.a != load.b || store.b != load.c || load.b == t || load.c == t) return false;
    const bool is_product = op == OpCode::MADDEL || op == OpCode::MSUBEL;
    std::uint32_t value = change.c;
    if (is_product) {
      if (change.b == t || change.c == t) return false;
    } else if (change.b != t) {
      if (!properties_of(change.op).commutes || change.c != t) return false;
      value = change.b;
    }
    if (change.op != OpCode::ADDIK && !is_product && value == t) return false;
    if (!deaths_.dies(t, at + 2)) return false;
    load = {op, store.a, store.b, is_product ? 0 : value, load.label, load.expr, load.span};
    const bool can_fail = op == OpCode::COUNTEL || op == OpCode::ADDEL || op == OpCode::SUBEL;
    if (can_fail) {
      make_operand(at + 1, OpCode::PAIR, load.a, load.b, 0);
    } else {
      remove(at + 1);
    }
    make_operand(at + 2, OpCode::PAIR, is_product ? change.b : load.a,
                 is_product ? change.c : load.b, 0);
    return true;
  }

  bool copy_element(std::uint32_t at) {
    if (!is_straight(at, 2)) return false;
    WideInstr& load = code_[at];
    const WideInstr store = code_[at + 1];
    const std::uint32_t t = load.a;
    if (store.op != OpCode::ST || store.c != t || store.a == t || store.b == t) return false;
    if (!deaths_.dies(t, at + 1)) return false;
    load = {OpCode::COPYEL, 0, load.b, load.c, load.label, load.expr, load.span};
    make_operand(at + 1, OpCode::PAIR, store.a, store.b, 0);
    return true;
  }

  void scale(std::uint32_t at) {
    if (!is_straight(at, 2)) return;
    WideInstr& product = code_[at];
    const WideInstr sum = code_[at + 1];
    const std::uint32_t t = product.a;
    if (sum.op != OpCode::ADDIK || sum.b != t) return;
    if (sum.a != t && !deaths_.dies(t, at + 1)) return;
    product.op = variant_of(Variant::kAndAddSmall, product.op);
    product.a = sum.a;
    make_operand(at + 1, OpCode::OFFSET, 0, 0, sum.c);
  }

  bool count_and_branch(std::uint32_t at) {
    if (!is_straight(at, 2)) return false;
    WideInstr& sum = code_[at];
    WideInstr& test = code_[at + 1];
    if (sum.a != sum.b || !is_compare_and_branch(test.op) || can_choose(at + 1)) return false;
    const bool immediate = operand_of(test.op, 1) == 'i';
    const bool second = !immediate && test.b == sum.a;
    if (second == (test.a == sum.a)) return false;
    const OpCode op = counting(test.op, second, sum.c);
    if (op == kNoVariant) return false;
    const std::uint32_t with = second ? test.a : test.b;
    const bool is_told = operand_of(op, 2) == 'i';
    sum = {op, sum.a, with, is_told ? sum.c : 0, sum.label, sum.expr, sum.span};
    // The jump stays in the last word, behind the comparison.
    test = code_[at + 2];
    remove_jump(at + 2);
    return true;
  }

  // Removes the word of the jump, whose contents have moved up.
  void remove_jump(std::uint32_t at) {
    code_[at].label = WideInstr::kNoLabel;
    remove(at);
  }

  bool can_choose(std::uint32_t at) const {
    const Choice choice = otherwise(code_[at].op);
    if (choice.move == kNoVariant || !is_straight(at, 3)) return false;
    const WideInstr& jump = code_[at + 1];
    const WideInstr& body = code_[at + 2];
    if (jump.op != OpCode::JUMP || shape_.labels[jump.label] != at + 3) return false;
    return body.op == OpCode::MOVE || (body.op == OpCode::ADDIK && body.a == body.b);
  }

  void choose_without_branch(std::uint32_t at) {
    if (!can_choose(at)) return;
    WideInstr& test = code_[at];
    WideInstr& jump = code_[at + 1];
    const WideInstr body = code_[at + 2];
    const Choice choice = otherwise(test.op);
    const bool counts = body.op == OpCode::ADDIK;
    const bool turned = choice.turned;
    --ways_[at + 3];
    const WideInstr chosen{counts ? choice.count : choice.move,
                           body.a,
                           counts ? 0 : body.b,
                           counts ? body.c : 0,
                           test.label,
                           body.expr,
                           body.span};
    const WideInstr operands{OpCode::PAIR,
                             turned ? test.b : test.a,
                             turned ? test.a : test.b,
                             0,
                             WideInstr::kNoLabel,
                             test.expr,
                             test.span};
    if (test.op == OpCode::FORX) {
      test = {OpCode::ADDIK, test.a, test.a, 1, test.label, test.expr, test.span};
      jump = chosen;
      code_[at + 2] = operands;
    } else {
      test = chosen;
      jump = operands;
      remove(at + 2);
    }
  }

  // t = i + k, if t is used only as an index, and first by the next instruction.
  bool look_beside(std::uint32_t at) {
    const WideInstr sum = code_[at];
    const std::uint32_t t = sum.a;
    if (t == sum.b || deaths_.is_live_in_handler(t, at)) return false;
    if (!is_straight(at, 2) || !find_indexings(at, t, sum.b)) return false;
    for (const std::uint32_t late : uses_) {
      WideInstr& instr = code_[late];
      const bool loads = instr.op == OpCode::LD;
      instr.op = loads ? OpCode::LDO : OpCode::STO;
      (loads ? instr.c : instr.b) = sum.b;
      if (late != at + 1) late_.push_back({late, sum.c});
    }
    const WideInstr combined = code_[at + 1];
    code_[at] = {combined.op, combined.a, combined.b, combined.c, sum.label, sum.expr, sum.span};
    make_operand(at + 1, OpCode::OFFSET, 0, 0, sum.c);
    return true;
  }

  // Finds all instructions that read t before it gets another value; the first is the next
  // instruction.
  bool find_indexings(std::uint32_t at, std::uint32_t t, std::uint32_t base) {
    uses_.clear();
    const std::uint32_t end = std::min(deaths_.block_end(at), at + kFarthestPair);
    bool base_stays = true;
    for (std::uint32_t i = at + 1; i < end;) {
      const Effects effects = effects_of(code_, i);
      const WideInstr& instr = code_[i];
      const bool loads = instr.op == OpCode::LD && instr.c == t && instr.b != t;
      const bool stores = instr.op == OpCode::ST && instr.b == t && instr.a != t && instr.c != t;
      if (loads || stores) {
        if (!base_stays || uses_.size() == kMostUses) return false;
        uses_.push_back(i);
      } else if (reads_register(code_, i, effects, t)) {
        return false;
      }
      if (i == at + 1 && uses_.empty()) return false;
      if (effects.defines && instr.a == t) return true;
      if (effects.defines && instr.a == base) base_stays = false;
      if (effects.empties && instr.b == base) base_stays = false;
      if (effects.has_window && base >= effects.window.bits) base_stays = false;
      i += effects.words;
    }
    return !uses_.empty() && deaths_.dies(t, uses_.back());
  }

  // Elements with the index i + k need a second word for k. It is inserted at the position of the
  // instruction, so that jumps to the instruction still lead to its first word.
  void split_late_words() {
    std::ranges::sort(late_, {}, &Late::at);
    for (const Late& late : late_) {
      edits_.insertions.push_back({late.at, false, code_[late.at]});
      make_operand(late.at, OpCode::OFFSET, 0, 0, late.offset);
    }
  }

  struct Late {
    std::uint32_t at;
    std::uint32_t offset;
  };

  std::vector<WideInstr>& code_;
  const CodeShape& shape_;
  Deaths deaths_;
  std::vector<std::uint32_t> ways_;  // count of jumps and handlers that lead to each position
  std::vector<std::uint32_t> uses_;
  std::vector<Late> late_;
  Edits edits_;
};

}  // namespace

Edits combine(std::vector<WideInstr>& code, const CodeShape& shape) {
  return Combiner(code, shape).run();
}

}  // namespace armlet::lang
