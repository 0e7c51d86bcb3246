#include "lower/optimise/liveness.hpp"

#include <algorithm>

#include "lower/optimise/effects.hpp"

namespace armlet::lang {

namespace {

constexpr std::size_t kLongestFunction = 20'000;
constexpr std::size_t kMostWords = 1U << 18U;  // words of all sets together
constexpr int kMostSteps = 32;                 // from two blocks up to their common dominator

bool test(const std::vector<std::uint64_t>& bits, std::uint32_t i) {
  return (bits[i / 64] >> (i % 64) & 1U) != 0;
}
void set(std::vector<std::uint64_t>& bits, std::uint32_t i) { bits[i / 64] |= 1ULL << (i % 64); }

}  // namespace

Liveness::Liveness(const std::vector<WideInstr>& code, const CodeShape& shape, RegClass watched)
    : code_(code),
      watched_(watched),
      registers_(watched == RegClass::kNumber ? shape.numbers : shape.references),
      words_((registers_ + 63) / 64) {
  if (code.empty() || code.size() > kLongestFunction) return;
  find_blocks(shape);
  if (blocks_.size() * words_ > kMostWords) return;
  link_blocks(shape);
  solve();
  known_ = true;
}

void Liveness::find_blocks(const CodeShape& shape) {
  std::vector<bool> begins(code_.size() + 1, false);
  begins[0] = true;
  for (const std::uint32_t position : shape.labels) {
    if (position <= code_.size()) begins[position] = true;
  }
  for (const auto& handler : shape.handlers) begins[handler.handler] = true;
  for (std::uint32_t at = 0; at < code_.size();) {
    const std::uint32_t next = at + effects_of(code_, at).words;
    if (properties_of(code_[at].op).flow != ControlFlow::kNext) begins[next] = true;
    at = next;
  }
  block_of_.assign(code_.size() + 1, 0);
  for (std::uint32_t at = 0; at < code_.size(); ++at) {
    if (begins[at]) {
      if (!blocks_.empty()) blocks_.back().end = at;
      blocks_.push_back({.begin = at, .end = static_cast<std::uint32_t>(code_.size())});
    }
    block_of_[at] = static_cast<std::uint32_t>(blocks_.size() - 1);
  }
}

void Liveness::link_blocks(const CodeShape& shape) {
  for (std::uint32_t i = 0; i < blocks_.size(); ++i) {
    CodeBlock& block = blocks_[i];
    bool falls_through = true;
    for (std::uint32_t at = block.begin; at < block.end;) {
      const std::uint32_t words = effects_of(code_, at).words;
      const bool branches = is_compare_and_branch(code_[at].op);
      for (std::uint32_t word = at; word < at + words; ++word) {
        const std::uint32_t label = code_[word].label;
        if (label != WideInstr::kNoLabel) block.next.push_back(block_at(shape.labels[label]));
      }
      falls_through = branches || !ends_flow(code_[at].op);
      at += words;
    }
    if (falls_through && i + 1 < blocks_.size()) block.next.push_back(i + 1);
  }
  find_dominators(shape);
  for (const auto& handler : shape.handlers) {
    if (handler.begin >= handler.end) continue;
    const std::uint32_t last = block_at(handler.end - 1);
    for (std::uint32_t i = block_at(handler.begin); i <= last; ++i)
      blocks_[i].handlers.push_back(block_at(handler.handler));
  }
}

// Blocks are in the order of the text, so only loops lead to an earlier block. A handler may be
// reached from any instruction.
void Liveness::find_dominators(const CodeShape& shape) {
  std::vector<bool> is_handler(blocks_.size(), false);
  for (const auto& handler : shape.handlers) is_handler[block_at(handler.handler)] = true;
  std::vector<bool> seen(blocks_.size(), false);
  const auto common = [&](std::uint32_t a, std::uint32_t b) {
    for (int steps = 0; a != b && a != CodeBlock::kNone && b != CodeBlock::kNone; ++steps) {
      if (steps == kMostSteps) return CodeBlock::kNone;
      std::uint32_t& later = a > b ? a : b;
      later = blocks_[later].dominator;
    }
    return a == b ? a : CodeBlock::kNone;
  };
  for (std::uint32_t i = 0; i < blocks_.size(); ++i) {
    for (const std::uint32_t next : blocks_[i].next) {
      CodeBlock& block = blocks_[next];
      if (next <= i) {
        block.loop_last = i;
      } else if (!is_handler[next]) {
        block.dominator = seen[next] ? common(block.dominator, i) : i;
        seen[next] = true;
      }
    }
  }
}

// Collects the registers that a block reads before it writes them, and those that it writes.
void Liveness::read_block(const CodeBlock& block, Bits& reads, Bits& writes) const {
  // The registers from this one on count as read already; only those below can be new.
  std::uint32_t read_from = registers_;
  const auto read = [&](Reg reg) {
    if (is_watched(reg) && !test(writes, reg.number())) set(reads, reg.number());
  };
  for (std::uint32_t at = block.begin; at < block.end;) {
    const Effects effects = effects_of(code_, at);
    for_each_read(code_, at, effects, [&](std::uint32_t bits) { read(Reg{bits}); });
    if (effects.effect == Effect::kUpdate) read(Reg{code_[at].a});
    if (effects.has_fixed) read(effects.fixed);
    const bool unknown = effects.effect == Effect::kUnknown;
    if (unknown || (effects.has_window && is_watched(effects.window))) {
      const std::uint32_t first = unknown ? 0 : effects.window.number();
      const bool all = unknown || effects.window_reads == Effects::kAll;
      const std::uint32_t end = all ? read_from : std::min(read_from, first + effects.window_reads);
      for (std::uint32_t n = first; n < end; ++n) read(Reg::make(watched_, n));
      if (all) read_from = std::min(read_from, first);
    }
    if (effects.defines && !unknown && is_watched(Reg{code_[at].a})) {
      set(writes, Reg{code_[at].a}.number());
    }
    at += effects.words;
  }
}

void Liveness::solve() {
  live_in_.assign(blocks_.size(), Bits(words_, 0));
  std::vector<Bits> writes(blocks_.size(), Bits(words_, 0));
  for (std::size_t i = 0; i < blocks_.size(); ++i) read_block(blocks_[i], live_in_[i], writes[i]);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = blocks_.size(); i-- > 0;) {
      for (std::size_t w = 0; w < words_; ++w) {
        std::uint64_t live = live_in_[i][w];
        for (const std::uint32_t next : blocks_[i].next) live |= live_in_[next][w] & ~writes[i][w];
        for (const std::uint32_t handler : blocks_[i].handlers) live |= live_in_[handler][w];
        changed = changed || live != live_in_[i][w];
        live_in_[i][w] = live;
      }
    }
  }
}

bool Liveness::is_live_after(std::uint32_t block, Reg reg) const {
  return std::ranges::any_of(
      blocks_[block].next, [&](std::uint32_t next) { return test(live_in_[next], reg.number()); });
}

bool Liveness::is_live_in_handler(std::uint32_t block, Reg reg) const {
  return std::ranges::any_of(blocks_[block].handlers, [&](std::uint32_t handler) {
    return test(live_in_[handler], reg.number());
  });
}

}  // namespace armlet::lang
