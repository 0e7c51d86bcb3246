#pragma once
// Where the variables of a function are.

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "hir/hir.hpp"
#include "program/wide.hpp"

namespace armlet::lang {

// Variables of the program are not here: they have a number (hir::Variable::index).
class Homes {
 public:
  // The register of a local variable, or the one with its box. It has been given one.
  [[nodiscard]] Reg of(const hir::Variable& variable) const { return registers_.at(&variable); }
  // A variable of an inlined function gets a register for each call.
  void give(const hir::Variable& variable, Reg reg) {
    registers_[&variable] = reg;
    given_.push_back({&variable, reg, {}, variable.declared.end, 0, 0});
  }

  // ---- for debuggers: which of them can be seen where
  struct Given {
    const hir::Variable* variable;
    Reg reg;
    Span scope;           // empty: not known yet
    std::uint32_t opens;  // not seen before this byte of the text
    std::uint32_t begin;  // of the code of the scope: what is done finally has several copies
    std::uint32_t end;
  };
  [[nodiscard]] std::size_t count() const { return given_.size(); }
  [[nodiscard]] const std::vector<Given>& given() const { return given_; }
  // Where lowering stood.
  struct Point {
    std::size_t count;
    std::uint32_t position;  // in the code
  };
  // Those that were given since then have their first values at this byte.
  void open(Point since, std::uint32_t at) {
    for (std::size_t i = since.count; i < given_.size(); ++i) given_[i].opens = at;
  }
  // Those that were given since then can be seen in these bytes of the text and in the code up to
  // `position`, unless they have a scope already; none before its first value.
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
