#include "lower/optimise/value_numbering.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "lower/optimise/effects.hpp"

namespace armlet::lang {

namespace {

constexpr std::uint32_t kFarthestRepetition =
    300;  // instructions between a value and its repeated computation

bool is_number(Reg reg) { return reg.reg_class() == RegClass::kNumber; }

// Whether the instruction stores into a list or record of a variable. Such a store leaves the
// values of other variables unchanged, because variables do not share lists.
bool stores_in_variable(const WideInstr& instr, Effect effect, std::uint32_t& holder) {
  if (effect != Effect::kStoreA && effect != Effect::kStoreB) return false;
  holder = effect == Effect::kStoreA ? instr.a : instr.b;
  return Reg{holder}.is_reference();
}

bool changes_memory(Effect effect) {
  switch (effect) {
    case Effect::kPure:
    case Effect::kLoad:
    case Effect::kInside:
    case Effect::kUpdate:
    case Effect::kLocal:
      return false;
    case Effect::kStoreA:
    case Effect::kStoreB:
    case Effect::kMemory:
    case Effect::kUnknown:
      return true;
  }
  return true;
}

class RepeatFinder {
 public:
  RepeatFinder(std::vector<WideInstr>& code, const CodeShape& shape, const Liveness& liveness,
               const std::function<Reg()>& fresh)
      : code_(code), shape_(shape), liveness_(liveness), fresh_(fresh), gone_(code.size(), false) {}

  Edits run() {
    count_followers();
    for (block_ = 0; block_ < liveness_.blocks().size(); ++block_) number_block();
    std::ranges::stable_sort(insertions_, {}, &Insertion::at);
    return {std::move(gone_), std::move(insertions_)};
  }

 private:
  // The key of a value: the instruction, the numbers of its operands' values, the region, and for
  // loads the state of memory.
  using Key = std::array<std::uint64_t, 8>;
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::uint64_t hash = 0;
      for (const std::uint64_t part : key) hash = (hash ^ part) * 0x9E37'79B9'7F4A'7C15ULL;
      return static_cast<std::size_t>(hash ^ hash >> 32U);
    }
  };
  struct Known {
    std::uint32_t value;
    std::uint32_t at;  // the instruction that computes it, or stores it
    Reg home;          // the register with the result
  };
  using Values = std::array<std::vector<std::uint32_t>, 4>;
  // The known values at the end of a block, for later blocks that begin with them.
  struct Snapshot {
    Values values;
    std::uint32_t region;
    std::uint32_t first_value;
    std::uint32_t top_number;
    std::uint64_t memory;
    std::uint64_t borrowed;
    std::unordered_map<std::uint32_t, std::uint64_t> stored;
  };
  // A loop around the current block, with the values of the registers before it.
  struct Loop {
    std::uint32_t begin;  // of its code
    std::uint32_t last;   // block
    Values values;
  };
  static constexpr std::size_t kMostSnapshots = 16;  // at a time
  static constexpr std::size_t kLargestSnapshot = 512;
  static constexpr std::uint32_t kMostSkipped =
      2000;  // instructions between a block and its dominator

  const CodeBlock& block() const { return liveness_.blocks()[block_]; }

  // Starts a region in which no register has a known value.
  void forget() {
    region_ = ++last_region_;
    first_value_ = last_value_ + 1;
    top_number_ = 0;
  }

  // Counts for each block the blocks, apart from the next one, that begin with the values known at
  // its end.
  void count_followers() {
    const auto& blocks = liveness_.blocks();
    followers_.assign(blocks.size(), 0);
    for (std::uint32_t i = 0; i < blocks.size(); ++i) {
      const std::uint32_t from = blocks[i].dominator;
      if (from != CodeBlock::kNone && from + 1 != i) ++followers_[from];
    }
  }

  void begin_block() {
    while (!loops_.empty() && loops_.back().last < block_) loops_.pop_back();
    const std::uint32_t from = block().dominator;
    if (from == CodeBlock::kNone) return forget();
    if (from + 1 != block_ && !take_snapshot(from)) return forget();
    if (block().loop_last != CodeBlock::kNone) begin_loop(from);
    lose_between(from);
  }

  bool take_snapshot(std::uint32_t from) {
    const auto kept = snapshots_.find(from);
    if (kept == snapshots_.end()) return false;
    const bool is_last = --followers_[from] == 0;
    Snapshot at_end = is_last ? std::move(kept->second) : kept->second;
    if (is_last) snapshots_.erase(kept);
    values_ = std::move(at_end.values);
    region_ = at_end.region;
    first_value_ = at_end.first_value;
    top_number_ = at_end.top_number;
    memory_ = at_end.memory;
    borrowed_ = at_end.borrowed;
    stored_ = std::move(at_end.stored);
    return true;
  }

  void end_block() {
    if (followers_[block_] == 0) return;
    if (snapshots_.size() >= kMostSnapshots || size_of_values() > kLargestSnapshot) return;
    snapshots_[block_] = {values_, region_, first_value_, top_number_, memory_, borrowed_, stored_};
  }

  std::size_t size_of_values() const {
    std::size_t size = 0;
    for (const auto& values : values_) size += values.size();
    return size;
  }

  // Code can be inserted before a loop only if the loop is entered from the block above it, without
  // a jump.
  void begin_loop(std::uint32_t from) {
    const std::uint32_t begin = block().begin;
    if (from + 1 != block_ || !shape_.handlers.empty() || size_of_values() > kLargestSnapshot)
      return;
    for (std::uint32_t at = liveness_.blocks()[from].begin; at < begin; ++at) {
      const std::uint32_t label = code_[at].label;
      if (label != WideInstr::kNoLabel && shape_.labels[label] == begin) return;
    }
    loops_.push_back({begin, block().loop_last, values_});
  }

  // Removes the values that may change between the dominator and the current block: in the blocks
  // between the two, and in later iterations of loops that begin there.
  void lose_between(std::uint32_t from) {
    const auto& blocks = liveness_.blocks();
    std::uint32_t end = block_;
    for (std::uint32_t i = from + 1; i <= block_; ++i) {
      const std::uint32_t last = blocks[i].loop_last;
      if (last != CodeBlock::kNone && last >= block_) end = std::max(end, last + 1);
    }
    if (end == from + 1) return;
    const std::uint32_t first = blocks[from + 1].begin;
    const std::uint32_t behind = blocks[end - 1].end;
    if (behind - first > kMostSkipped) return forget();
    for (std::uint32_t at = first; at < behind;) {
      const Effects effects = effects_of(code_, at);
      if (effects.effect == Effect::kUnknown) return forget();
      lose_changed(at, effects);
      at += effects.words;
    }
  }

  void lose_changed(std::uint32_t at, const Effects& effects) {
    const WideInstr& instr = code_[at];
    if (gone_[at]) return;
    change_memory(at, effects);
    if (effects.has_window) lose_window(effects.window);
    if (effects.empties) set_value(Reg{instr.b}, ++last_value_);
    if (effects.defines) set_value(Reg{instr.a}, ++last_value_);
  }

  void change_memory(std::uint32_t at, const Effects& effects) {
    std::uint32_t holder = 0;
    if (stores_in_variable(code_[at], effects.effect, holder)) {
      stored_[holder] = borrowed_ = ++last_memory_;
    } else if (changes_memory(effects.effect)) {
      memory_ = ++last_memory_;
    }
  }

  // The state of memory that a load at this position depends on, besides its operands.
  std::uint64_t memory_for(std::uint32_t at) const {
    if (properties_of(code_[at].op).effect != Effect::kInside) return memory_;
    const Reg holder{code_[at].b};
    const bool is_variable = holder.is_reference() || holder.reg_class() == RegClass::kParameter;
    if (!is_variable) return std::max(memory_, borrowed_);
    const auto stored = stored_.find(holder.bits);
    return stored == stored_.end() ? memory_ : std::max(memory_, stored->second);
  }

  void number_block() {
    begin_block();
    for (std::uint32_t at = block().begin; at < block().end;) {
      const Effects effects = effects_of(code_, at);
      number(at, effects);
      at += effects.words;
    }
    end_block();
  }

  void number(std::uint32_t at, const Effects& effects) {
    const Reg to{code_[at].a};
    if (effects.effect == Effect::kUnknown) {
      forget();
    } else if (is_value(effects.effect)) {
      number_value(at, effects);
      return;
    }
    change_memory(at, effects);
    if (code_[at].op == OpCode::GSTORE) note_stored(at);
    if (effects.has_window) lose_window(effects.window);
    if (effects.empties) set_value(Reg{code_[at].b}, ++last_value_);
    if (effects.defines) {
      const bool copies = code_[at].op == OpCode::MOVE;
      set_value(to, copies ? value_of(Reg{code_[at].b}) : ++last_value_);
    }
  }

  // After a store to a global variable its value is known without a load.
  void note_stored(std::uint32_t at) {
    const Reg from{code_[at].b};
    Key key{};
    key[0] = static_cast<std::uint64_t>(OpCode::GLOAD);
    key[1] = std::uint64_t{region_} << 32U | memory_;
    key[2] = code_[at].a;
    known_.insert_or_assign(key, Known{value_of(from), at, from});
  }

  void number_value(std::uint32_t at, const Effects& effects) {
    const Reg to{code_[at].a};
    const auto [known, is_new] = known_.try_emplace(key_of(at, effects), Known{0, at, to});
    Known& entry = known->second;
    if (is_new) {
      entry.value = ++last_value_;
    } else if (value_of(to) == entry.value) {
      remove(at, effects);  // the register has this value already
      return;
    } else if (is_number(to) && (reuse(entry, at) || keep_through_loop(entry, at))) {
      remove(at, effects);
      return;
    } else if (is_load(effects.effect) && value_of(entry.home) == entry.value) {
      replace_by_move(at, effects, entry.home);
    } else if (value_of(entry.home) != entry.value) {
      entry.at = at;  // a closer register, still valid
      entry.home = to;
    }
    set_value(to, entry.value);
  }

  Key key_of(std::uint32_t at, const Effects& effects) {
    Key key{};
    key[0] = static_cast<std::uint64_t>(code_[at].op);
    key[1] = std::uint64_t{region_} << 32U | (is_load(effects.effect) ? memory_for(at) : 0);
    std::size_t next = 2;
    for (std::uint32_t word = at; word < at + effects.words; ++word) {
      const std::uint32_t operands[] = {code_[word].a, code_[word].b, code_[word].c};
      for (std::size_t i = word == at ? 1 : 0; i < 3; ++i) {
        const bool reg = is_register(operand_of(code_[word].op, i));
        key[next++] = reg ? std::uint64_t{1} << 32U | value_of(Reg{operands[i]}) : operands[i];
      }
    }
    return key;
  }

  std::uint32_t& value_in(Reg reg) {
    std::vector<std::uint32_t>& values = values_[static_cast<std::size_t>(reg.reg_class())];
    if (reg.number() >= values.size()) values.resize(reg.number() + 16, 0);
    if (is_number(reg)) top_number_ = std::max(top_number_, reg.number());
    return values[reg.number()];
  }
  std::uint32_t value_of(Reg reg) {
    std::uint32_t& value = value_in(reg);
    if (value < first_value_) value = ++last_value_;
    return value;
  }
  void set_value(Reg reg, std::uint32_t value) { value_in(reg) = value; }

  void lose_window(Reg window) {
    if (!is_number(window)) return;
    for (std::uint32_t n = window.number(); n <= top_number_; ++n) {
      set_value(Reg::make(RegClass::kNumber, n), ++last_value_);
    }
  }

  void remove(std::uint32_t at, const Effects& effects) {
    for (std::uint32_t word = at; word < at + effects.words; ++word) gone_[word] = true;
  }

  void replace_by_move(std::uint32_t at, const Effects& effects, Reg home) {
    WideInstr& instr = code_[at];
    instr.op = OpCode::MOVE;
    instr.b = home.bits;
    instr.c = 0;
    for (std::uint32_t word = at + 1; word < at + effects.words; ++word) gone_[word] = true;
  }

  // Collects the reads of register `reg` after `at` until it gets another value; returns false if
  // they cannot be changed. `keeper` is the register to read instead, which must keep its value
  // until the last of these reads.
  bool collect_reads(Reg reg, std::uint32_t at, const Reg* keeper, bool may_outlive_block) {
    reads_.clear();
    if (is_counter(reg) || liveness_.is_live_in_handler(block_, reg)) return false;
    bool kept = true;
    const std::uint32_t end = std::min(block().end, at + kFarthestRepetition);
    for (std::uint32_t i = at + effects_of(code_, at).words; i < end;) {
      const Effects effects = effects_of(code_, i);
      if (gone_[i]) {
        i += effects.words;
        continue;
      }
      const std::size_t before = reads_.size();
      for_each_read(code_, i, effects, [&](std::uint32_t& bits) {
        if (bits == reg.bits) reads_.push_back(&bits);
      });
      if (reads_.size() > before && (!kept || effects.empties)) return false;
      if (!leaves_free(effects, i, reg)) return false;
      if (effects.defines && code_[i].a == reg.bits) return true;
      if (keeper != nullptr && changes(effects, i, *keeper)) kept = false;
      i += effects.words;
    }
    return may_outlive_block ? false : end == block().end && !liveness_.is_live_after(block_, reg);
  }

  // Whether the instruction uses the register only as a named operand, which can be replaced.
  bool leaves_free(const Effects& effects, std::uint32_t at, Reg reg) const {
    if (effects.effect == Effect::kUnknown) return false;
    if (effects.effect == Effect::kUpdate && code_[at].a == reg.bits) return false;
    if (effects.has_window && reg.bits >= effects.window.bits) return false;
    return !effects.has_fixed || effects.fixed != reg;
  }

  bool changes(const Effects& effects, std::uint32_t at, Reg reg) const {
    if (effects.defines && code_[at].a == reg.bits) return true;
    if (effects.empties && code_[at].b == reg.bits) return true;
    return effects.has_window && is_number(reg) && reg.bits >= effects.window.bits;
  }

  bool is_counter(Reg reg) const {
    return std::ranges::find(shape_.counters, reg) != shape_.counters.end();
  }

  // A register had the value before a surrounding loop: the loop keeps it in a register of its own.
  bool keep_through_loop(Known& entry, std::uint32_t at) {
    for (const Loop& loop : loops_) {
      for (std::size_t c = 0; c < loop.values.size(); ++c) {
        const auto found = std::ranges::find(loop.values[c], entry.value);
        if (found == loop.values[c].end()) continue;
        if (!collect_reads(Reg{code_[at].a}, at, nullptr, false)) return false;
        const Reg own = fresh_();
        const auto number = static_cast<std::uint32_t>(found - loop.values[c].begin());
        const Reg before = Reg::make(static_cast<RegClass>(c), number);
        const WideInstr& first = code_[loop.begin];
        insertions_.push_back({loop.begin,
                               true,
                               {OpCode::MOVE, own.bits, before.bits, 0, WideInstr::kNoLabel,
                                first.expr, first.span}});
        for (std::uint32_t* read : reads_) *read = own.bits;
        entry.at = at;
        entry.home = own;
        set_value(own, entry.value);
        return true;
      }
    }
    return false;
  }

  // Lets the readers of the value that is computed again at `at` read the register that has it
  // already.
  bool reuse(Known& entry, std::uint32_t at) {
    const Reg home = entry.home;
    const Reg again{code_[at].a};
    if (value_of(home) == entry.value) {
      if (!collect_reads(again, at, &home, false)) return false;
      for (std::uint32_t* read : reads_) *read = home.bits;
      return true;
    }
    // The register of the value has another one now: the value moves to a fresh register, unless
    // code outside of this block may read the old one.
    if (entry.at < block().begin || Reg{code_[entry.at].a} != home) return false;
    if (!is_number(home) || !collect_reads(again, at, nullptr, false)) return false;
    const std::vector<std::uint32_t*> late = reads_;
    if (!collect_reads(home, entry.at, nullptr, true)) return false;
    const Reg own = fresh_();
    code_[entry.at].a = own.bits;
    for (std::uint32_t* read : reads_) *read = own.bits;
    for (std::uint32_t* read : late) *read = own.bits;
    entry.home = own;
    set_value(own, entry.value);
    return true;
  }

  std::vector<WideInstr>& code_;
  const CodeShape& shape_;
  const Liveness& liveness_;
  const std::function<Reg()>& fresh_;
  std::vector<bool> gone_;
  std::uint32_t block_ = 0;
  std::unordered_map<Key, Known, Hash> known_;
  Values values_;  // by class and number of the register
  std::uint32_t region_ = 0;
  std::uint32_t first_value_ = 1;  // smaller ones are no longer valid in this region
  std::uint32_t last_value_ = 0;
  std::uint32_t top_number_ = 0;  // the highest number register with a value
  // Counters of changes: of memory; of objects that registers other than variables may refer to;
  // and by register, of single variables when nothing else changes.
  std::uint64_t memory_ = 0;
  std::uint64_t borrowed_ = 0;
  std::unordered_map<std::uint32_t, std::uint64_t> stored_;
  std::uint32_t last_region_ = 0;
  std::uint64_t last_memory_ = 0;
  std::vector<std::uint32_t> followers_;
  std::vector<Loop> loops_;  // around the block, the innermost last
  std::vector<Insertion> insertions_;
  std::unordered_map<std::uint32_t, Snapshot> snapshots_;  // by block
  std::vector<std::uint32_t*> reads_;
};

}  // namespace

Edits number_values(std::vector<WideInstr>& code, const CodeShape& shape,
                    const std::function<Reg()>& fresh) {
  const Liveness liveness(code, shape);
  if (!liveness.is_known()) return {};
  return RepeatFinder(code, shape, liveness, fresh).run();
}

}  // namespace armlet::lang
