#pragma once
// Questions about checked expressions and statements that decide how code for them may be arranged.

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <unordered_set>
#include <utility>
#include <vector>

#include "armlet/interpreter/object.hpp"
#include "hir/hir.hpp"

namespace armlet::lang {

// Functions whose bodies stand in place of their calls.
using FunctionSet = std::unordered_set<const hir::Function*>;

template <class Kind>
[[nodiscard]] bool is_one_of(Kind kind, std::initializer_list<Kind> kinds) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

// The bits of a scalar that the text alone gives; false if there are none.
[[nodiscard]] bool constant_slot(const hir::Expr& expr, Slot& out);
// A known int, bool or enum value that fits a small operand.
[[nodiscard]] bool small_int(const hir::Expr& expr, std::int64_t& out);

// Nothing else of the program runs, and no variable changes, while it is evaluated. It may fail.
// Calls of the functions in `inlined` run nothing else either.
[[nodiscard]] bool is_quiet(const hir::Expr& expr, const FunctionSet& inlined = {});
// Only arithmetic that cannot fail, on constants and variables of this function.
[[nodiscard]] bool is_plain(const hir::Expr& expr);
// push, pop, insert or removeAt happens somewhere in it.
[[nodiscard]] bool mutates(const hir::Expr& expr);
[[nodiscard]] bool mentions(const hir::Expr& expr, const hir::Variable& variable);
// The variable that a chain of fields and elements starts from; null if it starts from something
// else.
[[nodiscard]] const hir::Variable* root_variable(const hir::Expr& expr);

// What a statement does to one variable.
struct VariableUse {
  const hir::Variable* variable = nullptr;
  bool assigned = false;  // as a whole, or its list changes its length
  bool element = false;   // an element or field of it is assigned
  bool whole = false;     // its value is used as a whole: copied, passed, compared
};

// What a loop does: how it uses variables, in the order of the text, and whether other code may run
// meanwhile.
struct Summary {
  bool quiet = true;
  std::vector<VariableUse> uses;
  [[nodiscard]] const VariableUse* find(const hir::Variable* variable) const;
  [[nodiscard]] bool assigns(const hir::Variable* variable) const;
};
[[nodiscard]] Summary summarise(const hir::Stmt& loop, const FunctionSet& inlined);

}  // namespace armlet::lang
