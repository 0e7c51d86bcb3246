#include "lower/optimise/fuse.hpp"

#include <algorithm>

#include "lower/optimise/deaths.hpp"
#include "lower/optimise/effects.hpp"

namespace armlet::lang {

namespace {

class Fuser {
 public:
  Fuser(std::vector<WideInstr>& code, const CodeShape& shape)
      : code_(code), flow_(find_flow(code, shape)), deaths_(code, shape) {}

  Edits run() {
    edits_.removed.assign(code_.size(), false);
    for (std::uint32_t at = 0; at < code_.size();) {
      const std::uint32_t next = at + effects_of(code_, at).words;
      if (next < code_.size() && !flow_.targets[next]) {
        if (code_[at].op == OpCode::MULR) join_products(at);
        if (code_[at].op == OpCode::LD) join_elements(at);
      }
      at = std::max(next, at + effects_of(code_, at).words);
    }
    return std::move(edits_);
  }

 private:
  // t = a * b; t = t + c * d
  void join_products(std::uint32_t at) {
    WideInstr& product = code_[at];
    WideInstr& sum = code_[at + 1];
    if (!has_variant(Variant::kProductInstead, sum.op)) return;
    if (sum.a != product.a || sum.b == product.a || sum.c == product.a) return;
    product.op = variant_of(Variant::kProductInstead, sum.op);
    sum.op = OpCode::PAIR;
    sum.a = sum.b;
    sum.b = sum.c;
    sum.c = 0;
  }

  // t = x[k]; s = s + t * y[j], or s + t * rows[i][j], if no other instruction reads t.
  void join_elements(std::uint32_t at) {
    WideInstr& load = code_[at];
    WideInstr& sum = code_[at + 1];
    const std::uint32_t t = load.a;
    const bool from_row = sum.op == OpCode::MADDLDLD;
    if (!has_variant(Variant::kElementInstead, sum.op)) return;
    WideInstr& word = code_[at + 2];
    const bool other_use = sum.a == t || sum.b == t || sum.c == t || (from_row && word.b == t);
    if (word.a != t || other_use || !deaths_.dies(t, at + 1)) return;
    load.op = variant_of(Variant::kElementInstead, sum.op);
    load.a = sum.a;
    sum.op = OpCode::PAIR;
    sum.a = sum.b;
    sum.b = sum.c;
    sum.c = 0;
    if (from_row) {
      word.op = OpCode::WITH;
      word.a = word.b;
      word.b = 0;
    } else {
      edits_.removed[at + 2] = true;
    }
  }

  std::vector<WideInstr>& code_;
  CodeFlow flow_;
  Deaths deaths_;
  Edits edits_;
};

}  // namespace

Edits fuse(std::vector<WideInstr>& code, const CodeShape& shape) {
  return Fuser(code, shape).run();
}

}  // namespace armlet::lang
