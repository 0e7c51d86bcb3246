#pragma once
// Uses of a variable that may be its last one, so that its value can be moved instead of copied.

#include <algorithm>
#include <vector>

#include "hir/hir.hpp"

namespace armlet::lang {

class LastUses {
 public:
  // The whole value that a statement assigns or returns, or the call that is the statement.
  void set_whole(const hir::Expr* value) { whole_ = value; }
  [[nodiscard]] bool is_whole(const hir::Expr& value) const { return whole_ == &value; }

  // A loop borrows the elements of a list while it runs.
  void lend(const hir::Variable& list) { lent_.push_back(&list); }
  void take_back() { lent_.pop_back(); }
  [[nodiscard]] bool is_lent(const hir::Variable& variable) const {
    return std::ranges::find(lent_, &variable) != lent_.end();
  }

 private:
  const hir::Expr* whole_ = nullptr;
  std::vector<const hir::Variable*> lent_;
};

}  // namespace armlet::lang
