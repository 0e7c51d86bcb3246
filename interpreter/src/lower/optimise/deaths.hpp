#pragma once
// Whether what a number register, or a reference register, holds is still needed.

#include <optional>
#include <vector>

#include "lower/optimise/liveness.hpp"

namespace armlet::lang {

class Deaths {
 public:
  Deaths(const std::vector<WideInstr>& code, const CodeShape& shape,
         RegClass watched = RegClass::kNumber)
      : code_(code), shape_(shape), watched_(watched) {}

  // Nobody reads what register `bits` holds after the instruction at `at`. The code may have been
  // changed since the first question where that changes no registers that outlive a block.
  [[nodiscard]] bool dies(std::uint32_t bits, std::uint32_t at);
  // A failure of the instruction at `at` leads to where the register may be read.
  [[nodiscard]] bool is_live_in_handler(std::uint32_t bits, std::uint32_t at);
  // The end of the block with the instruction at `at`; 0 if nothing is known.
  [[nodiscard]] std::uint32_t block_end(std::uint32_t at);

 private:
  [[nodiscard]] bool look();
  [[nodiscard]] std::uint32_t block_of(std::uint32_t at) const;

  const std::vector<WideInstr>& code_;
  const CodeShape& shape_;
  RegClass watched_;
  std::optional<Liveness> liveness_;  // when it is first needed
};

}  // namespace armlet::lang
