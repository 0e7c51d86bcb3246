#pragma once
// The loops around what is being lowered, and the variables of the program that they keep in
// registers.

#include <unordered_map>
#include <vector>

#include "hir/hir.hpp"
#include "program/wide.hpp"

namespace armlet::lang {

class Loops {
 public:
  void begin() { pinned_before_.push_back(pinned_.size()); }
  // What the innermost loop keeps is in its register no longer.
  void end() {
    for (; pinned_.size() > pinned_before_.back(); pinned_.pop_back()) {
      registers_.erase(pinned_.back());
    }
    pinned_before_.pop_back();
  }
  [[nodiscard]] bool any() const { return !pinned_before_.empty(); }

  // Until the innermost loop ends the variable of the program is in this register.
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
  std::vector<std::size_t> pinned_before_;  // by loop: how many were pinned when it began
  std::vector<const hir::Variable*> pinned_;
  std::unordered_map<const hir::Variable*, Reg> registers_;
};

}  // namespace armlet::lang
