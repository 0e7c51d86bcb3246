#pragma once
// What is known about values from the text alone: constants, and facts that rules of the host have
// left.

#include <optional>
#include <unordered_map>

#include "hir/hir.hpp"
#include "vocabulary/signature.hpp"

namespace armlet::lang {

struct Checker;

// The constants that variables stand for.
class Constants {
 public:
  // The value of an expression; empty if the text does not show it.
  [[nodiscard]] std::optional<Constant> of(const hir::Expr& expr) const { return at(expr, 0); }
  // Finds what a variable stands for, once, when it is declared: `let b = a + a; let c = b + b ...`
  // would take twice as long with every line. What is large is not known through variables.
  void note(const hir::Variable& variable);

 private:
  [[nodiscard]] std::optional<Constant> at(const hir::Expr& expr, int depth) const;

  std::unordered_map<const hir::Variable*, std::optional<Constant>> known_;
};

// What rules of the host have found out about a value; null: nothing.
[[nodiscard]] const Fact* fact_of(const hir::Expr& expr);
// The expression behind fixed variables.
[[nodiscard]] const hir::Expr& origin_of(const hir::Expr& expr);

// A constant written as a value of `type`.
hir::Expr* literal_of(Checker& checker, const Constant& constant, const Type* type, Span span);
// Arithmetic on two literals as a literal; others as they are.
hir::Expr* folded(Checker& checker, hir::BinaryExpr* expr);

}  // namespace armlet::lang
