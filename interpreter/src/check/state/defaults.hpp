#pragma once
// Default values of parameters and fields, each checked when it is first needed.

#include <unordered_map>
#include <utility>

#include "ast/ast.hpp"
#include "check/scopes/uses.hpp"

namespace armlet::lang {

struct Default {
  hir::Expr* value = nullptr;
  hir::Function* function = nullptr;  // gives the value; null: it is so small that it is repeated
  Use use{};                          // what the value mentions
  bool is_open = false;               // being checked
};

class Defaults {
 public:
  // Stays where it is; and whether it is new.
  std::pair<Default*, bool> find(const ast::Expr& expr) {
    const auto [entry, is_new] = known_.try_emplace(&expr);
    return {&entry->second, is_new};
  }

  // A call takes one; gives how many all calls have taken.
  std::size_t take() { return ++taken_; }

 private:
  std::unordered_map<const ast::Expr*, Default> known_;
  std::size_t taken_ = 0;
};

}  // namespace armlet::lang
