#pragma once
// Finds out whether the contents of a number register or reference register are still needed.

#include <optional>
#include <vector>

#include "lower/optimise/liveness.hpp"

namespace armlet::lang {

class Deaths {
 public:
  Deaths(const std::vector<WideInstr>& code, const CodeShape& shape,
         RegClass watched = RegClass::kNumber)
      : code_(code), shape_(shape), watched_(watched) {}

  // Whether no instruction reads the contents that register `bits` has after the instruction at
  // `at`. Between two questions the code may change, except for registers that are used in several
  // blocks.
  [[nodiscard]] bool dies(std::uint32_t bits, std::uint32_t at);
  // Whether a failure of the instruction at `at` leads to code that may read the register.
  [[nodiscard]] bool is_live_in_handler(std::uint32_t bits, std::uint32_t at);
  // The end of the block with the instruction at `at`; 0 if it is not known.
  [[nodiscard]] std::uint32_t block_end(std::uint32_t at);

 private:
  [[nodiscard]] bool look();
  [[nodiscard]] std::uint32_t block_of(std::uint32_t at) const;

  const std::vector<WideInstr>& code_;
  const CodeShape& shape_;
  RegClass watched_;
  std::optional<Liveness> liveness_;  // made at the first question
};

}  // namespace armlet::lang
