#pragma once
// Where the variables of a function are.

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "check/tree/hir.hpp"
#include "compile/code/wide.hpp"

namespace armlet::lang {

// Variables of the program are not here: they have a number (hir::Variable::index).
class Homes {
 public:
  // The register of a local variable, or the one with its box. It has been given one.
  [[nodiscard]] Reg of(const hir::Variable& variable) const { return registers_.at(&variable); }
  // A variable of an inlined function gets a register for each call.
  void give(const hir::Variable& variable, Reg reg) {
    registers_[&variable] = reg;
    given_.push_back({&variable, reg, {}});
  }

  // ---- for debuggers: which of them can be seen where
  struct Given {
    const hir::Variable* variable;
    Reg reg;
    Span scope;  // empty: not known yet
  };
  [[nodiscard]] std::size_t count() const { return given_.size(); }
  [[nodiscard]] const std::vector<Given>& given() const { return given_; }
  // From `begin` on those that were given since there were `count` can be seen up to `end`, unless
  // they have a scope already; each of them not before its own declaration.
  void close(std::size_t count, std::uint32_t begin, std::uint32_t end) {
    for (; count < given_.size(); ++count) {
      Given& each = given_[count];
      const Span declared = each.variable->declared;
      if (each.scope.empty()) each.scope = {std::max(begin, declared.end), end, declared.source};
    }
  }

 private:
  std::unordered_map<const hir::Variable*, Reg> registers_;
  std::vector<Given> given_;
};

}  // namespace armlet::lang
