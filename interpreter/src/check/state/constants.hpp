#pragma once
// Facts about values that follow from the text: constants, and facts that rules of the host have
// stored.

#include <optional>
#include <unordered_map>

#include "hir/hir.hpp"
#include "vocabulary/signature.hpp"

namespace armlet::lang {

struct Checker;

// The constants that are values of variables.
class Constants {
 public:
  // The value of an expression; empty if it does not follow from the text.
  [[nodiscard]] std::optional<Constant> of(const hir::Expr& expr) const { return at(expr, 0); }
  // Finds the constant value of a variable once, at its declaration: for `let b = a + a; let c = b
  // + b ...` a later search would take twice as long with every line. Large values of variables are
  // not stored.
  void note(const hir::Variable& variable);

 private:
  [[nodiscard]] std::optional<Constant> at(const hir::Expr& expr, int depth) const;

  std::unordered_map<const hir::Variable*, std::optional<Constant>> known_;
};

// The fact that rules of the host have stored for a value; null if there is none.
[[nodiscard]] const Fact* fact_of(const hir::Expr& expr);
// The initialiser of a constant variable, followed through further ones; other expressions
// unchanged.
[[nodiscard]] const hir::Expr& origin_of(const hir::Expr& expr);

// The literal of `type` for a constant.
hir::Expr* literal_of(Checker& checker, const Constant& constant, const Type* type, Span span);
// The literal for an operation on two literals; other expressions unchanged.
hir::Expr* folded(Checker& checker, hir::BinaryExpr* expr);

}  // namespace armlet::lang
