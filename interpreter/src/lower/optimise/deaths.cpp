#include "lower/optimise/deaths.hpp"

#include <algorithm>

#include "lower/optimise/effects.hpp"

namespace armlet::lang {

namespace {

constexpr std::uint32_t kFarthestUse = 300;  // instructions in which uses of a value are searched

}  // namespace

bool Deaths::look() {
  if (!liveness_) liveness_.emplace(code_, shape_, watched_);
  return liveness_->is_known();
}

std::uint32_t Deaths::block_of(std::uint32_t at) const {
  const auto& blocks = liveness_->blocks();
  const auto block = std::ranges::upper_bound(blocks, at, {}, &CodeBlock::end);
  return static_cast<std::uint32_t>(block - blocks.begin());
}

std::uint32_t Deaths::block_end(std::uint32_t at) {
  return look() ? liveness_->blocks()[block_of(at)].end : 0;
}

bool Deaths::is_live_in_handler(std::uint32_t bits, std::uint32_t at) {
  const Reg reg{bits};
  if (reg.reg_class() != watched_ || !look()) return true;
  return liveness_->is_live_in_handler(block_of(at), reg);
}

bool Deaths::dies(std::uint32_t bits, std::uint32_t at) {
  if (is_live_in_handler(bits, at)) return false;
  const std::uint32_t block = block_of(at);
  const std::uint32_t begin = at + effects_of(code_, at).words;
  const std::uint32_t end = liveness_->blocks()[block].end;
  for (std::uint32_t i = begin; i < end;) {
    if (i - begin > kFarthestUse) return false;
    const Effects effects = effects_of(code_, i);
    if (reads_register(code_, i, effects, bits)) return false;
    if (effects.defines && code_[i].a == bits) return true;
    i += effects.words;
  }
  return !liveness_->is_live_after(block, Reg{bits});
}

}  // namespace armlet::lang
