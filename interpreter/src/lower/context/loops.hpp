#pragma once
// The loops around the code that is emitted, and the global variables that they keep in registers.

#include <unordered_map>
#include <vector>

#include "hir/hir.hpp"
#include "program/wide.hpp"

namespace armlet::lang {

class Loops {
 public:
  void begin() { pinned_before_.push_back(pinned_.size()); }
  // Ends the innermost loop: the global variables that it kept are no longer in registers.
  void end() {
    for (; pinned_.size() > pinned_before_.back(); pinned_.pop_back()) {
      registers_.erase(pinned_.back());
    }
    pinned_before_.pop_back();
  }
  [[nodiscard]] bool any() const { return !pinned_before_.empty(); }

  // Keeps a global variable in a register until the innermost loop ends.
  void pin(const hir::Variable& variable, Reg reg) {
    pinned_.push_back(&variable);
    registers_.emplace(&variable, reg);
  }
  [[nodiscard]] bool is_pinned(const hir::Variable& variable, Reg& out) const {
    const auto known = registers_.find(&variable);
    if (known == registers_.end()) return false;
    out = known->second;
    return true;
  }

 private:
  std::vector<std::size_t> pinned_before_;  // by loop: the count of kept variables when it began
  std::vector<const hir::Variable*> pinned_;
  std::unordered_map<const hir::Variable*, Reg> registers_;
};

}  // namespace armlet::lang
