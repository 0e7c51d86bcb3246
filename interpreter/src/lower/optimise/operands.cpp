#include "lower/optimise/operands.hpp"

#include <algorithm>

#include "lower/optimise/deaths.hpp"
#include "lower/optimise/effects.hpp"

namespace armlet::lang {

namespace {

class OperandTaker {
 public:
  OperandTaker(std::vector<WideInstr>& code, const CodeShape& shape)
      : code_(code), flow_(find_flow(code, shape)), deaths_(code, shape) {}

  Edits run() {
    edits_.removed.assign(code_.size(), false);
    for (std::uint32_t at = 0; at < code_.size(); at += effects_of(code_, at).words) look_at(at);
    return std::move(edits_);
  }

 private:
  void look_at(std::uint32_t at) {
    const OpCode op = code_[at].op;
    if (op == OpCode::LD) {
      (void)(compare(at) || test_truth(at) || operate(at) || add_product(at));
    } else if (op == OpCode::LDLD) {
      add_element_of_row(at);
    } else if (op == OpCode::GLOAD) {
      load_from_global(at);
    } else if (op == OpCode::GOWN) {
      store_in_global(at);
    } else if (op == OpCode::MULI || op == OpCode::ADDI) {
      (void)(operate_twice(at) || step(at));
    } else if (has_variant(Variant::kIfZero, op)) {
      test_zero(at);
    } else if (op == OpCode::TEXT) {
      compare_with_text(at);
    }
  }

  // The instruction after the `words` words of this one; null if a jump leads to it.
  const WideInstr* after(std::uint32_t at, std::uint32_t words) const {
    const std::uint32_t next = at + words;
    return next < code_.size() && !flow_.targets[next] ? &code_[next] : nullptr;
  }

  WideInstr replaced(std::uint32_t at, OpCode op, std::uint32_t a, std::uint32_t b,
                     std::uint32_t c) const {
    const WideInstr& old = code_[at];
    return {op, a, b, c, old.label, old.expr, old.span};
  }
  void make(std::uint32_t at, OpCode op, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    code_[at] = replaced(at, op, a, b, c);
  }
  void remove(std::uint32_t at) {
    make(at, OpCode::OFFSET, 0, 0, 0);
    code_[at].label = WideInstr::kNoLabel;
    edits_.removed[at] = true;
  }
  // Moves the jump of the comparison behind into this instruction.
  void take_jump(std::uint32_t at, std::uint32_t test) {
    code_[at + 1] = code_[test + 1];
    if (test != at) {
      for (std::uint32_t word = at + 2; word < test + 2; ++word) remove(word);
    }
  }

  // t = x[i]; if t < v ...
  bool compare(std::uint32_t at) {
    const WideInstr& load = code_[at];
    const WideInstr* test = after(at, 1);
    if (test == nullptr || !is_compare_and_branch(test->op)) return false;
    const std::uint32_t t = load.a;
    const bool with_small = operand_of(test->op, 1) == 'i';
    const bool on_right = !with_small && test->a != t;
    if (on_right ? test->b != t : test->a != t || (!with_small && test->b == t)) return false;
    const OpCode op =
        variant_of(on_right ? Variant::kElementRight : Variant::kElementLeft, test->op);
    const std::uint32_t other = on_right ? test->a : test->b;
    if (op == kNoVariant || !deaths_.dies(t, at + 1)) return false;
    make(at, op, load.b, load.c, other);
    take_jump(at, at + 1);
    return true;
  }

  // t = x[i]; jump if t is true
  bool test_truth(std::uint32_t at) {
    const WideInstr& load = code_[at];
    const WideInstr* test = after(at, 1);
    if (test == nullptr || (test->op != OpCode::JT && test->op != OpCode::JF)) return false;
    if (test->a != load.a || !deaths_.dies(load.a, at + 1)) return false;
    make(at, test->op == OpCode::JT ? OpCode::IFNEXK : OpCode::IFEQXK, load.b, load.c, 0);
    make(at + 1, OpCode::JUMP, 0, 0, 0);
    return true;
  }

  // t = x[i]; u = v + t
  bool operate(std::uint32_t at) {
    const WideInstr& load = code_[at];
    const WideInstr* next = after(at, 1);
    if (next == nullptr) return false;
    const std::uint32_t t = load.a;
    if (next->a != t && !deaths_.dies(t, at + 1)) return false;
    if (next->op == OpCode::ADDIK) {
      if (next->b != t) return false;
      const std::uint32_t added = next->c;
      make(at, OpCode::ADDIXK, next->a, load.b, load.c);
      make(at + 1, OpCode::OFFSET, 0, 0, added);
      return true;
    }
    if (properties_of(next->op).flow != ControlFlow::kNext) return false;
    const bool on_right = next->b != t;
    const OpCode op =
        variant_of(on_right ? Variant::kElementRight : Variant::kElementLeft, next->op);
    if (op == kNoVariant || (on_right ? next->c != t : next->c == t)) return false;
    const std::uint32_t other = on_right ? next->b : next->c;
    make(at, op, next->a, load.b, load.c);
    make(at + 1, OpCode::WITH, other, 0, 0);
    return true;
  }

  // t = y[j]; x[i] = x[i] + a * t
  bool add_product(std::uint32_t at) {
    const WideInstr& load = code_[at];
    const WideInstr* change = after(at, 1);
    const OpCode op =
        change == nullptr ? kNoVariant : variant_of(Variant::kElementFactor, change->op);
    if (op == kNoVariant) return false;
    const WideInstr& factors = code_[at + 2];
    const std::uint32_t t = load.a;
    const std::uint32_t list = change->a;
    const std::uint32_t index = change->b;
    if ((factors.a == t) == (factors.b == t) || list == t || index == t) return false;
    if (!deaths_.dies(t, at + 1)) return false;
    const std::uint32_t other = factors.a == t ? factors.b : factors.a;
    const WideInstr element = load;
    make(at, op, list, index, other);
    make(at + 1, OpCode::PAIR, element.b, element.c, 0);
    make(at + 2, OpCode::PAIR, list, index, 0);
    return true;
  }

  // t = rows[i][j]; u = v + t
  void add_element_of_row(std::uint32_t at) {
    const WideInstr& load = code_[at];
    const WideInstr* sum = after(at, 2);
    const OpCode op = sum == nullptr ? kNoVariant : variant_of(Variant::kElementOfRow, sum->op);
    if (op == kNoVariant) return;
    const std::uint32_t t = load.a;
    if ((sum->b == t) == (sum->c == t)) return;
    if (sum->a != t && !deaths_.dies(t, at + 2)) return;
    const std::uint32_t other = sum->b == t ? sum->c : sum->b;
    make(at, op, sum->a, load.b, load.c);
    make(at + 2, OpCode::WITH, other, 0, 0);
  }

  // t = global; u = t[i], with only computations between the two.
  void load_from_global(std::uint32_t at) {
    const std::uint32_t t = code_[at].a;
    const std::uint32_t global = code_[at].b;
    std::uint32_t i = at + 1;
    for (; i < code_.size() && !flow_.targets[i]; i += effects_of(code_, i).words) {
      const Effects effects = effects_of(code_, i);
      if (reads_register(code_, i, effects, t)) break;
      if (effects.effect != Effect::kPure || code_[i].a == t) return;
    }
    if (i >= code_.size() || flow_.targets[i] || code_[i].op != OpCode::LD) return;
    const WideInstr& load = code_[i];
    if (load.b != t || load.c == t || (load.a != t && !deaths_.dies(t, i))) return;
    make(i, OpCode::LDG, load.a, global, load.c);
    remove(at);
  }

  // t = global, as the only owner; t[i] = v
  void store_in_global(std::uint32_t at) {
    const WideInstr own = code_[at];
    const WideInstr* store = after(at, 1);
    if (store == nullptr || store->op != OpCode::ST || store->a != own.a) return;
    if (store->b == own.a || store->c == own.a || !deaths_.dies(own.a, at + 1)) return;
    make(at + 1, OpCode::STG, own.b, store->b, store->c);
    remove(at);
  }

  // t = a * b; u = t + c
  bool operate_twice(std::uint32_t at) {
    const WideInstr& first = code_[at];
    const WideInstr* next = after(at, 1);
    if (next == nullptr || (next->op != OpCode::ADDIK && next->op != OpCode::ADDI)) return false;
    const bool with_small = next->op == OpCode::ADDIK;
    const std::uint32_t t = first.a;
    if (with_small ? next->b != t : (next->b == t) == (next->c == t)) return false;
    if (next->a != t && !deaths_.dies(t, at + 1)) return false;
    const OpCode op = variant_of(with_small ? Variant::kAndAddSmall : Variant::kAndAdd, first.op);
    if (op == kNoVariant) return false;
    const std::uint32_t added = with_small ? next->c : next->b == t ? next->c : next->b;
    make(at, op, next->a, first.b, first.c);
    make(at + 1, with_small ? OpCode::OFFSET : OpCode::WITH, with_small ? 0 : added, 0,
         with_small ? added : 0);
    return true;
  }

  // i = i + k; if i < n ...
  bool step(std::uint32_t at) {
    const WideInstr& sum = code_[at];
    const WideInstr* test = after(at, 1);
    if (test == nullptr || sum.op != OpCode::ADDI) return false;
    if ((sum.b == sum.a) == (sum.c == sum.a)) return false;
    const OpCode op = variant_of(Variant::kBehindStep, test->op);
    const bool with_small = operand_of(op, 1) == 'i';
    const std::uint32_t by = sum.b == sum.a ? sum.c : sum.b;
    if (op == kNoVariant || test->a != sum.a) return false;
    if (!with_small && test->b == sum.a) return false;
    make(at, op, sum.a, test->b, by);
    take_jump(at, at + 1);
    return true;
  }

  // t = a % b; if t == 0 ...; likewise with the order of two texts.
  void test_zero(std::uint32_t at) {
    const WideInstr& number = code_[at];
    const WideInstr* test = after(at, 1);
    if (test == nullptr || test->a != number.a || test->b != 0) return;
    if (test->op != OpCode::IFEQIK && test->op != OpCode::IFNEIK) return;
    if (!deaths_.dies(number.a, at + 1)) return;
    const Variant variant = test->op == OpCode::IFEQIK ? Variant::kIfZero : Variant::kIfNotZero;
    make(at, variant_of(variant, number.op), number.b, number.c, 0);
    take_jump(at, at + 1);
  }

  // t = "x"; u = order of t and another text; if u == 0 ...
  void compare_with_text(std::uint32_t at) {
    const WideInstr& text = code_[at];
    const WideInstr* order = after(at, 1);
    const WideInstr* test = after(at, 2);
    if (order == nullptr || test == nullptr || order->op != OpCode::CMPTEXT) return;
    const std::uint32_t t = text.a;
    if ((order->b == t) == (order->c == t) || test->a != order->a || test->b != 0) return;
    if (test->op != OpCode::IFEQIK && test->op != OpCode::IFNEIK) return;
    if (!deaths_.dies(order->a, at + 2)) return;
    if (order->a != t && !deaths_.dies(t, at + 1)) return;
    const std::uint32_t other = order->b == t ? order->c : order->b;
    const OpCode op = test->op == OpCode::IFEQIK ? OpCode::IFEQTK : OpCode::IFNETK;
    // A failure of the joined instruction belongs to the comparison in the text.
    WideInstr comparison = replaced(at + 1, op, other, text.b, 0);
    comparison.label = WideInstr::kNoLabel;
    code_[at] = comparison;
    take_jump(at, at + 2);
  }

  std::vector<WideInstr>& code_;
  CodeFlow flow_;
  Deaths deaths_;
  Edits edits_;
};

}  // namespace

Edits take_operands(std::vector<WideInstr>& code, const CodeShape& shape) {
  return OperandTaker(code, shape).run();
}

}  // namespace armlet::lang
