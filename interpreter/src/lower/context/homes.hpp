#pragma once
// The registers of the local variables of a function.

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "hir/hir.hpp"
#include "program/wide.hpp"

namespace armlet::lang {

// Global variables are not in this table: they have a number (hir::Variable::index).
class Homes {
 public:
  // The register of a local variable, or of its box. The variable must have one.
  [[nodiscard]] Reg of(const hir::Variable& variable) const { return registers_.at(&variable); }
  // Gives a variable its register. A variable of an inlined function gets another one for each
  // call.
  void give(const hir::Variable& variable, Reg reg) {
    registers_[&variable] = reg;
    given_.push_back({&variable, reg, {}, variable.declared.end, 0, 0});
  }

  // ---- for debuggers: which of them can be seen where
  struct Given {
    const hir::Variable* variable;
    Reg reg;
    Span scope;           // empty: not known yet
    std::uint32_t opens;  // visible from this byte of the text on
    std::uint32_t begin;  // of the code of the scope; the code of `finally` exists several times
    std::uint32_t end;
  };
  [[nodiscard]] std::size_t count() const { return given_.size(); }
  [[nodiscard]] const std::vector<Given>& given() const { return given_; }
  // A position in the code, with the count of variables that have registers there.
  struct Point {
    std::size_t count;
    std::uint32_t position;  // in the code
  };
  // The variables since that point have their first values at this byte of the text.
  void open(Point since, std::uint32_t at) {
    for (std::size_t i = since.count; i < given_.size(); ++i) given_[i].opens = at;
  }
  // The variables since that point without a scope are visible in this span of the text and in the
  // code up to `position`; each only after its first value.
  void close(Point since, Span scope, std::uint32_t position) {
    for (std::size_t i = since.count; i < given_.size(); ++i) {
      Given& each = given_[i];
      if (!each.scope.empty()) continue;
      const Span declared = each.variable->declared;
      each.scope = {std::max(scope.begin, each.opens), scope.end, declared.source};
      each.begin = since.position;
      each.end = position;
    }
  }

 private:
  std::unordered_map<const hir::Variable*, Reg> registers_;
  std::vector<Given> given_;
};

}  // namespace armlet::lang
