#pragma once
// Where the variables of a function are.

#include <unordered_map>

#include "check/tree/hir.hpp"
#include "compile/code/wide.hpp"

namespace armlet::lang {

// Variables of the program are not here: they have a number (hir::Variable::index).
class Homes {
 public:
  // The register of a local variable, or the one with its box. It has been given one.
  [[nodiscard]] Reg of(const hir::Variable& variable) const { return registers_.at(&variable); }
  // A variable of an inlined function gets a register for each call.
  void give(const hir::Variable& variable, Reg reg) { registers_[&variable] = reg; }

 private:
  std::unordered_map<const hir::Variable*, Reg> registers_;
};

}  // namespace armlet::lang
