#pragma once
// Properties of checked expressions and statements that the optimiser asks for: side effects,
// constant values, uses of variables.

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <unordered_set>
#include <utility>
#include <vector>

#include "armlet/interpreter/object.hpp"
#include "hir/hir.hpp"

namespace armlet::lang {

// Functions whose bodies replace their calls (inlining).
using FunctionSet = std::unordered_set<const hir::Function*>;

template <class Kind>
[[nodiscard]] bool is_one_of(Kind kind, std::initializer_list<Kind> kinds) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

// Stores the slot of a scalar expression whose value is known at compile time; returns false if the
// value is not known.
[[nodiscard]] bool constant_slot(const hir::Expr& expr, Slot& out);
// Stores the value of a constant of type int, bool or enum that fits the operand of an instruction;
// returns false for other expressions.
[[nodiscard]] bool small_int(const hir::Expr& expr, std::int64_t& out);

// Whether the evaluation has no side effect: it runs no other code of the program and changes no
// variable. It may fail. Calls of the functions in `inlined` count as part of the expression.
[[nodiscard]] bool is_quiet(const hir::Expr& expr, const FunctionSet& inlined = {});
// Whether the expression is arithmetic that cannot fail, on constants and variables of its own
// function.
[[nodiscard]] bool is_plain(const hir::Expr& expr);
// Whether the expression contains a call of push, pop, insert or removeAt.
[[nodiscard]] bool mutates(const hir::Expr& expr);
[[nodiscard]] bool mentions(const hir::Expr& expr, const hir::Variable& variable);
// The variable at the start of a chain of fields and elements, such as `a` in a.b[i].c; null if the
// chain starts from another expression.
[[nodiscard]] const hir::Variable* root_variable(const hir::Expr& expr);

// The effects of a statement on one variable.
struct VariableUse {
  const hir::Variable* variable = nullptr;
  bool assigned = false;  // as a whole, or its list changes its length
  bool element = false;   // an element or field of it is assigned
  bool whole = false;     // its value is used as a whole: copied, passed, compared
};

// The effects of a loop: how it uses variables, in the order of the text, and whether other code
// may run during the loop.
struct Summary {
  bool quiet = true;
  std::vector<VariableUse> uses;
  [[nodiscard]] const VariableUse* find(const hir::Variable* variable) const;
  [[nodiscard]] bool assigns(const hir::Variable* variable) const;
};
[[nodiscard]] Summary summarise(const hir::Stmt& loop, const FunctionSet& inlined);

}  // namespace armlet::lang
