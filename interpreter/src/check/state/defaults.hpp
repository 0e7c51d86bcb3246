#pragma once
// Default values of parameters and fields, each checked at its first use.

#include <unordered_map>
#include <utility>

#include "ast/ast.hpp"
#include "check/scopes/uses.hpp"

namespace armlet::lang {

struct Default {
  hir::Expr* value = nullptr;
  // Returns the value; null: small values are repeated at each use.
  hir::Function* function = nullptr;
  Use use{};             // the names that the value uses
  bool is_open = false;  // being checked
};

class Defaults {
 public:
  // The entry for an expression, whose address does not change, and whether it is new.
  std::pair<Default*, bool> find(const ast::Expr& expr) {
    const auto [entry, is_new] = known_.try_emplace(&expr);
    return {&entry->second, is_new};
  }

  // Counts a use of a default value; returns the count of all uses.
  std::size_t take() { return ++taken_; }

 private:
  std::unordered_map<const ast::Expr*, Default> known_;
  std::size_t taken_ = 0;
};

}  // namespace armlet::lang
